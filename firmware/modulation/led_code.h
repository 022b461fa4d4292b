// Which LEDs are wanted lit from one switching to the next.
#pragma once

#include <cstddef>
#include <cstdint>

#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/lit_leds.h"

namespace tripoint {

inline constexpr std::size_t kMaxSlots = 6;  ///< enough for kMaxTargetPoints: of 6 slots, 3 can be chosen in 20 ways

/// Steps repeat as: all, slot, all, all, slot. The pair of two that are alike keeps a light that blinks in every other
/// picture from being taken for an LED, and never are more than two steps between those in which all are lit.
///
/// In the slots, taken in turn, each LED shows its own code: it is lit in half of them, rounded down. So no code is
/// part of another: an LED that is missed where it is lit never shows the code of another one. A single LED has one
/// slot, in which it is out.
/// Source: Sperner 1928, "Ein Satz ueber Untermengen einer endlichen Menge": no larger set of such codes exists.
class LedCode {
 public:
  /// @param leds  1 to kMaxTargetPoints
  explicit LedCode(std::size_t leds);

  [[nodiscard]] LitLeds all() const { return all_; }
  [[nodiscard]] LitLeds lit_in(std::uint64_t step) const;
  /// Those of each slot.
  [[nodiscard]] const FixedVector<LitLeds, kMaxSlots>& slots() const { return slots_; }

 private:
  LitLeds all_;
  FixedVector<LitLeds, kMaxSlots> slots_;
};

}  // namespace tripoint
