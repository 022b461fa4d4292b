// Everything that a modulated unit has beyond another one: lines, what they did, and who believes what blinks.
#pragma once

#include <optional>

#include "capture/camera_worker.h"
#include "config/config.h"
#include "line/model.h"
#include "modulation/blinking_leds.h"
#include "modulation/led_switcher.h"
#include "modulation/switch_log.h"
#include "ports/clock.h"
#include "sim/simulated_leds.h"
#include "values/latest.h"
#include "values/side.h"

namespace tripoint {

class ModulationWiring {
 public:
  /// @param target  of at least one LED
  /// @param clock   must outlive this
  ModulationWiring(const ModulationConfig& config, const Target& target, const Clock& clock);

  /// For one camera's thread.
  SiftPoints sift(Side side);
  /// For the thread that switches.
  LedSwitcher switcher();
  [[nodiscard]] const SimulatedLeds& simulated_leds() const { return simulated_leds_; }

 private:
  const Clock& clock_;
  BlinkSettings settings_;
  SimulatedLeds simulated_leds_;
  SwitchLog log_;
  PerSide<Latest<std::optional<Rhythm>>> rhythms_;
};

}  // namespace tripoint
