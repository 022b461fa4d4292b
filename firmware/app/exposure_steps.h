// How a search goes from one exposure to the next.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "app/camera_pair.h"

namespace tripoint {

inline constexpr int kMostExposureSteps = 8;
inline constexpr double kLargestExposureStep = 4.0;  ///< a factor by which an exposure changes at once

constexpr double microseconds_of(std::chrono::microseconds exposure) { return static_cast<double>(exposure.count()); }

/// The nearest that is offered, in whole microseconds.
std::chrono::microseconds exposure_within(const ExposureOffer& offered, double exposure_us);

/// The largest step away from the start to both sides, then two, and so on, as far as is offered: where to look for
/// something that the start does not show.
std::vector<std::chrono::microseconds> exposures_around(const ExposureOffer& offered, std::chrono::microseconds start);

/// Between an exposure known to be too short and one too long it goes to the middle: at the knee where a channel clips,
/// luma does not follow the light well enough to go there at once.
class ExposureBracket {
 public:
  /// @param factor  of light that is missing (above 1) or too much
  double next_us(double exposure_us, double factor);

 private:
  std::optional<double> too_short_us_;
  std::optional<double> too_long_us_;
};

}  // namespace tripoint
