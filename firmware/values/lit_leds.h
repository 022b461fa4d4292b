// Which of a target's LEDs are lit.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "values/forecast.h"

namespace tripoint {

/// A set of LEDs, by their place in the target's list of points.
class LitLeds {
 public:
  constexpr LitLeds() = default;
  /// The first `count` of them.
  static constexpr LitLeds first(std::size_t count) { return LitLeds(static_cast<std::uint16_t>((1U << count) - 1U)); }

  constexpr void insert(std::size_t led) { bits_ = static_cast<std::uint16_t>(bits_ | (1U << led)); }
  [[nodiscard]] constexpr bool contains(std::size_t led) const { return ((bits_ >> led) & 1U) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  /// The only one; nothing when there are none or several.
  [[nodiscard]] constexpr std::optional<std::size_t> only() const {
    if (!std::has_single_bit(bits_)) return std::nullopt;
    return static_cast<std::size_t>(std::countr_zero(bits_));
  }
  [[nodiscard]] constexpr LitLeds both(LitLeds other) const {
    return LitLeds(static_cast<std::uint16_t>(bits_ & other.bits_));
  }
  [[nodiscard]] constexpr LitLeds without(LitLeds other) const {
    return LitLeds(static_cast<std::uint16_t>(bits_ & ~other.bits_));
  }
  friend constexpr bool operator==(LitLeds, LitLeds) = default;

 private:
  explicit constexpr LitLeds(std::uint16_t bits) : bits_(bits) {}
  std::uint16_t bits_ = 0;
};
static_assert(kMaxTargetPoints <= 16);

}  // namespace tripoint
