#include "app/exposure_steps.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr int kFarthest = 12;  ///< steps away from the start: a factor of 17 million

}  // namespace

std::chrono::microseconds exposure_within(const ExposureOffer& offered, double exposure_us) {
  return std::clamp(std::chrono::microseconds{std::llround(exposure_us)}, offered.shortest, offered.longest);
}

std::vector<std::chrono::microseconds> exposures_around(const ExposureOffer& offered, std::chrono::microseconds start) {
  std::vector<std::chrono::microseconds> exposures{exposure_within(offered, microseconds_of(start))};
  for (int distance = 1; distance <= kFarthest; ++distance) {
    for (const int steps : {-distance, distance}) {
      const double exposure_us = microseconds_of(start) * std::pow(kLargestExposureStep, steps);
      const bool beyond = exposure_us * kLargestExposureStep <= microseconds_of(offered.shortest) ||
                          exposure_us >= kLargestExposureStep * microseconds_of(offered.longest);
      if (!beyond) exposures.push_back(exposure_within(offered, exposure_us));
    }
  }
  return exposures;
}

double ExposureBracket::next_us(double exposure_us, double factor) {
  (factor > 1.0 ? too_short_us_ : too_long_us_) = exposure_us;
  if (too_short_us_ && too_long_us_) return std::sqrt(*too_short_us_ * *too_long_us_);
  return exposure_us * factor;
}

}  // namespace tripoint
