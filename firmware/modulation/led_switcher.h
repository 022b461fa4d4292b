// The loop of the thread that switches the LEDs between the cameras' exposures.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "modulation/led_code.h"
#include "modulation/switch_log.h"
#include "modulation/switching_moment.h"
#include "ports/clock.h"
#include "ports/switched_line.h"
#include "values/latest.h"

namespace tripoint {

using SwitchedLines = std::vector<std::unique_ptr<SwitchedLine>>;  ///< one for each LED, in the target's order

/// What the switcher shares with other threads; all of it outlives it.
struct SwitcherLinks {
  SwitchLog& log;
  const PerSide<Latest<std::optional<Rhythm>>>& rhythms;
  const Clock& clock;
  WaitUntil wait_until;
  std::function<void(std::string_view)> say;  ///< for the log: once when something is wrong, once when it is over
};

class LedSwitcher {
 public:
  LedSwitcher(SwitchedLines lines, SwitcherLinks links);

  /// Runs until stop is requested, noticed within one and a half periods of the cameras; then all LEDs go out. While no
  /// camera has a rhythm all are lit. A line that fails is set anew at the next step.
  void run(const std::stop_token& stop);

  /// One step of the code, or a wait for a camera.
  void step();

 private:
  [[nodiscard]] PerSide<std::optional<Rhythm>> recent_rhythms(TimePoint now) const;
  void show(LitLeds wanted);
  void judge(Duration clearance);

  SwitchedLines lines_;
  SwitcherLinks links_;
  LedCode code_;
  std::uint64_t step_ = 0;
  TimePoint previous_{};
  std::optional<LitLeds> shown_;  // nothing: not known
  bool failing_ = false;
  bool crowded_ = false;
};

}  // namespace tripoint
