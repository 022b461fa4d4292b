// Whether stated covariances hold the truth: over targets at many places, seen through many calibrations in error.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "bench/erring_units.h"
#include "values/linear.h"

namespace tripoint::bench {

struct CoveredTarget {
  std::string_view name;
  std::string_view key;           ///< the same for the name of a figure
  std::span<const Vec3> leds_mm;  ///< LEDs, or the centres of tags
  double tag_mm = 0.0;            ///< size of the tags; 0: LEDs
};
/// One LED; three of 100, 80, 60 mm; four, one of them out of the plane of the others.
std::span<const CoveredTarget> covered_leds();
/// One tag of 40 mm; three of 30 mm around the target's origin.
std::span<const CoveredTarget> covered_tags();

struct CoverageScore {
  int views = 0;
  int poses = 0;
  double inside_share = 0.0;       ///< of the poses: the truth is in the ellipsoid that holds 95 % of a Gaussian
  double axes_inside_share = 0.0;  ///< of all axes of all poses: the truth is within two standard deviations
  double position_rms_mm = 0.0;
  double orientation_rms_deg = 0.0;  ///< 0 for one LED
};

/// Views over the part of 300 x 300 x 200 mm around 400 mm that both cameras see (target_view), each with its own
/// calibration and its own target in error. Of tags the edges err by a fifth of `sources.spot_px` in their middles, and
/// each corner by `sources.spot_px` beside, as much as the detector states for what cameras do to edges.
CoverageScore coverage_score(const CoveredTarget& target, const ErrorSources& sources, std::uint64_t first_seed,
                             int views);

}  // namespace tripoint::bench
