// A whole unit on simulated cameras in one thread, on a clock that only waiting moves: the same on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "line/detect/led_detector.h"
#include "line/line.h"
#include "modulation/blinking_leds.h"
#include "modulation/led_switcher.h"
#include "modulation/switch_log.h"
#include "sim/draws.h"
#include "sim/frame_schedule.h"
#include "sim/simulated_camera.h"
#include "sim/simulated_leds.h"
#include "sim/world.h"

namespace tripoint::bench {

/// How the LEDs of a unit are switched.
struct Switching {
  Duration stamp_error{std::chrono::milliseconds{3}};
  Duration lateness{std::chrono::microseconds{500}};  ///< standard deviation by which the thread wakes too late
};

/// What a unit sees and says.
struct UnitWatcher {
  std::function<void(const Observation& believed, const FrameTruth& truth, const SimulatedWorld& world)> picture;
  std::function<void(const Measurement& verdict)> verdict;
};

class SteppedUnit {
 public:
  /// @param settings   YUYV; a light that can be switched has the number of its LED in the target, from 0
  /// @param switching  absent: the LEDs are always lit, and every spot is believed
  SteppedUnit(const SimulationSettings& settings, const LineModel& model, const std::optional<Switching>& switching,
              UnitWatcher watcher);
  SteppedUnit(const SteppedUnit&) = delete;
  SteppedUnit& operator=(const SteppedUnit&) = delete;
  ~SteppedUnit() = default;

  void run_for(Duration duration);

  static constexpr TimePoint kStart{std::chrono::seconds{1000}};  ///< on a clock without an offset to UTC

 private:
  class SteppedClock final : public Clock {
   public:
    [[nodiscard]] TimePoint now() const override { return now_; }
    [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
    [[nodiscard]] bool synchronised() const override { return true; }
    void move_to(TimePoint time) { now_ = std::max(now_, time); }

   private:
    TimePoint now_ = kStart;
  };
  /// One camera and what its thread has.
  struct Eye {
    std::unique_ptr<FrameSchedule> schedule;
    std::unique_ptr<SimulatedCamera> camera;
    std::unique_ptr<BlinkingLeds> blinking;
    LedDetector detector{LedDetectorSettings{}};
    std::uint64_t next = 0;
  };

  [[nodiscard]] TimePoint ready(Side side) const { return eyes_[side].schedule->ready(eyes_[side].next); }
  void look_until(TimePoint time);
  void look(Side side);

  SteppedClock clock_;
  SimulatedLeds leds_{clock_};
  SwitchLog log_;
  PerSide<Latest<std::optional<Rhythm>>> rhythms_;
  std::optional<SimulatedWorld> world_;
  PerSide<Eye> eyes_;
  Line line_;
  std::optional<LedSwitcher> switcher_;
  Draws lateness_;
  UnitWatcher watcher_;
};

}  // namespace tripoint::bench
