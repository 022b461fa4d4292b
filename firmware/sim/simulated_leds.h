// Lines that switch the simulated world's LEDs, and what the LEDs did.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>

#include "ports/clock.h"
#include "ports/switched_line.h"
#include "values/forecast.h"
#include "values/time.h"

namespace tripoint {

/// LEDs are out until a line is set. Threads may switch and look at the same time.
class SimulatedLeds {
 public:
  /// The clock must outlive this.
  explicit SimulatedLeds(const Clock& clock) : clock_(clock) {}

  /// @param led  below kMaxTargetPoints; the LEDs must outlive their lines
  std::unique_ptr<SwitchedLine> line(std::size_t led);

  /// Share of a time that is over in which the LED was lit; 0 or 1 when it has no length. Further back than the last
  /// kKept switchings, the LED counts as out.
  [[nodiscard]] double lit_share(std::size_t led, TimePoint from, TimePoint to) const;

  static constexpr std::size_t kKept = 128;

 private:
  class Line;
  struct Switching {
    TimePoint at = TimePoint::max();
    bool lit = false;
  };
  struct History {
    std::array<Switching, kKept> ring{};
    std::size_t next = 0;
  };
  void set(std::size_t led, bool lit);

  const Clock& clock_;
  mutable std::mutex mutex_;
  std::array<History, kMaxTargetPoints> histories_{};
};

}  // namespace tripoint
