#include "app/modulation_wiring.h"

#include <spdlog/spdlog.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "modulation/blink_watch.h"
#include "sim/simulated_camera.h"

namespace tripoint {
namespace {

BlinkSettings blink_settings(const ModulationConfig& config, const Target& target) {
  BlinkSettings settings{.leds = {}, .stamp_error = duration_from_seconds(config.stamp_error_ms * 1e-3)};
  for (const TargetPoint& point : target.points) settings.leds.push_back(static_cast<std::uint16_t>(point.id));
  return settings;
}

}  // namespace

ModulationWiring::ModulationWiring(const ModulationConfig& config, const Target& target, const Clock& clock)
    : clock_(clock), settings_(blink_settings(config, target)), simulated_leds_(clock) {}

SiftPoints ModulationWiring::sift(Side side) {
  // shared: a std::function must be copyable, and it owns them
  const auto blinking = std::make_shared<BlinkingLeds>(settings_, log_, rhythms_[side]);
  const auto watch = std::make_shared<BlinkWatch>();
  return [blinking, watch, side](const Observation& seen, const Picture& picture) {
    Observation sifted = blinking->sifted(seen, picture);
    if (const auto news = watch->news(blinking->verdicts(), seen.arrived)) {
      spdlog::warn("camera {}: {}", name(side), *news);
    }
    return sifted;
  };
}

LedSwitcher ModulationWiring::switcher() {
  SwitchedLines lines;
  for (std::size_t led = 0; led < settings_.leds.size(); ++led) lines.push_back(simulated_leds_.line(led));
  return {std::move(lines),
          {.log = log_,
           .rhythms = rhythms_,
           .clock = clock_,
           .wait_until = sleeping_by(clock_),
           .say = [](std::string_view what) { spdlog::warn("{}", what); }}};
}

}  // namespace tripoint
