#include "modulation/blink_watch.h"

#include <algorithm>

namespace tripoint {
namespace {

std::string remedy(std::ptrdiff_t ambient) {
  if (ambient == 0) return "no LED blinks, and no red light shines on: is the target in view, and its line connected?";
  return "no LED blinks, and " + std::to_string(ambient) +
         (ambient == 1 ? " red light shines on" : " red lights shine on") +
         ": if that is an LED, check its line, and modulation.stamp_error_ms; otherwise, is the target in view?";
}

}  // namespace

std::optional<std::string> BlinkWatch::news(const FixedVector<SpotVerdict, kMaxImagePoints>& verdicts,
                                            TimePoint arrived) {
  const auto count = [&](SpotVerdict verdict) { return std::count(verdicts.begin(), verdicts.end(), verdict); };
  if (!last_believed_) last_believed_ = arrived;
  if (count(SpotVerdict::kLed) > 0) {
    last_believed_ = arrived;
    if (!missing_) return std::nullopt;
    missing_ = false;
    return "LEDs blink again";
  }
  if (missing_ || arrived - *last_believed_ < kPatience) return std::nullopt;
  missing_ = true;
  return remedy(count(SpotVerdict::kAmbient));
}

}  // namespace tripoint
