// What the LEDs really did and when: written by the thread that switches, read by the cameras' threads.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <optional>

#include "values/lit_leds.h"
#include "values/time.h"

namespace tripoint {

/// A switching is entered before the first line changes and completed after the last one has. Whoever asks about a time
/// that is over gets an answer that no later entry can turn: what was switched then has been entered.
class SwitchLog {
 public:
  /// From now on the LEDs may be in any state.
  void begin(TimePoint at);
  /// From now on these are lit; nothing: a line failed and nobody knows.
  void complete(TimePoint at, std::optional<LitLeds> lit);

  /// @return those that were lit all the while; nothing when it changed, or is not known, or lies too far back
  [[nodiscard]] std::optional<LitLeds> during(TimePoint from, TimePoint to) const;

 private:
  struct Steady {
    TimePoint from{};
    std::optional<TimePoint> to;  // absent: up to now
    std::optional<LitLeds> lit;
  };
  static constexpr std::size_t kKept = 64;  // half a second at 120 pictures a second

  mutable std::mutex mutex_;
  std::array<Steady, kKept> ring_{};
  std::size_t next_ = 0;
  bool begun_ = false;
};

}  // namespace tripoint
