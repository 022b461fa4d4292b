// The 1000 registers that a client sees, most significant word first, and how values get into them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "contract/registers.h"
#include "serve/field.h"
#include "values/assert.h"

namespace tripoint {

class RegisterImage {
 public:
  static constexpr std::size_t kSize = registers::kImageLength;

  [[nodiscard]] std::uint16_t operator[](std::size_t address) const {
    TRIPOINT_ASSERT(address < kSize);
    return words_[address];
  }
  [[nodiscard]] const std::array<std::uint16_t, kSize>& words() const { return words_; }

  /// Writes the raw number of a field; `shift` moves it to a block that is like the field's own.
  template <typename T>
  void put(const registers::Field<T>& field, std::type_identity_t<T> raw, std::size_t shift = 0) {
    write(field.address + shift, raw);
  }
  template <typename T>
  void put(const registers::OptionalField<T>& field, std::optional<double> value, std::size_t shift = 0) {
    write(field.address + shift, registers::raw_of(field, value));
  }
  template <typename E>
  requires std::is_enum_v<E>
  void put(const registers::Field<std::uint16_t>& field, E choice, std::size_t shift = 0) {
    write(field.address + shift, static_cast<std::uint16_t>(choice));
  }

 private:
  template <typename T>
  void write(std::size_t address, T value) {
    if constexpr (std::is_floating_point_v<T>) {
      write(address, std::bit_cast<std::uint32_t>(value));
    } else {
      constexpr std::size_t kWords = sizeof(T) / 2;
      TRIPOINT_ASSERT(address + kWords <= kSize);
      const auto bits = static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<T>>(value));
      for (std::size_t word = 0; word < kWords; ++word) {
        words_[address + word] = static_cast<std::uint16_t>(bits >> (16U * (kWords - 1 - word)));
      }
    }
  }

  std::array<std::uint16_t, kSize> words_{};
};

/// The register of the image that the mirror at 2000 shows at each of its places: every value's words reversed.
extern const std::array<std::uint16_t, RegisterImage::kSize> kMirrorOrder;

}  // namespace tripoint
