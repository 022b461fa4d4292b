// What a light may be, by when it was there and when it was not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "modulation/led_code.h"
#include "values/lit_leds.h"

namespace tripoint {

/// Every picture in which it is known what was lit rules out what contradicts it, for as long as the light is followed.
class Blink {
 public:
  Blink() = default;
  /// It may be any of the LEDs, or none.
  explicit Blink(const LedCode& code) : code_(code), may_be_(code.all()) {}

  /// The light was there while these were lit.
  void take_seen(LitLeds lit);
  /// Its place was dark while these were lit.
  void take_dark(LitLeds lit);
  /// There was light at its place, but no spot of its own.
  void take_unclear(LitLeds lit);

  /// Which LED it is: the only one that is left, after each slot was seen or dark, and kTimesOut times dark, the last
  /// time that it had to be. Not for longer than kMostSeenInARow pictures without being dark: nobody switches any more.
  [[nodiscard]] std::optional<std::size_t> led() const;
  /// It is none of the LEDs, whatever comes.
  [[nodiscard]] bool none() const { return may_be_.empty(); }

  /// Between three times out there are always two pictures in a row in which all are lit.
  static constexpr int kTimesOut = 3;
  /// At most 9 are lit between two in which an LED has to be out, with 3 of 6 slots lit and one or two "all" beside
  /// each.
  static constexpr int kMostSeenInARow = 12;

 private:
  void note_slot(LitLeds lit);

  LedCode code_{1};
  LitLeds may_be_;
  LitLeds slots_known_;
  int times_out_ = 0;
  int seen_in_a_row_ = 0;
  bool out_last_ = false;
};

}  // namespace tripoint
