// A place in the register image with its type and scale, as the generated table contract/registers.h declares it.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace tripoint::registers {

/// A value that is always known. Value in its unit = raw number x `scale`; larger values read as `highest`.
template <typename T>
struct Field {
  std::uint16_t address;
  double scale;
  T highest;
};

/// A value that may be unknown, and the raw number that says so.
template <typename T>
struct OptionalField {
  std::uint16_t address;
  double scale;
  T highest;
  T unknown;
};

/// One value of the image: where it starts and how many registers it fills.
struct Row {
  std::uint16_t address;
  std::uint16_t words;
  std::string_view name;
};

/// A bit of a register of bits, as the map names it.
struct BitName {
  std::uint16_t bit;
  std::string_view name;
};

/// The raw number of a value, rounded; unknown when the value is absent, not finite or, for signed numbers, too
/// large. Unsigned numbers that are too large read as the highest one: "that or more".
template <typename T>
T raw_of(const OptionalField<T>& field, std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return field.unknown;
  if constexpr (std::is_floating_point_v<T>) {
    return std::abs(*value) <= static_cast<double>(field.highest) ? static_cast<T>(*value) : field.unknown;
  } else {
    const double raw = std::round(*value / field.scale);
    if constexpr (std::is_signed_v<T>) {
      return std::abs(raw) <= static_cast<double>(field.highest) ? static_cast<T>(raw) : field.unknown;
    } else {
      if (raw < 0.0) return field.unknown;
      return raw >= static_cast<double>(field.highest) ? field.highest : static_cast<T>(raw);
    }
  }
}

/// The raw number of a value that is known and not negative.
template <typename T>
T raw_of(const Field<T>& field, double value) {
  static_assert(std::is_unsigned_v<T>);
  const double raw = std::round(value / field.scale);
  if (!(raw > 0.0)) return 0;
  return raw >= static_cast<double>(field.highest) ? field.highest : static_cast<T>(raw);
}

}  // namespace tripoint::registers
