// Which exposure and gain suit a target at both ends of the working volume: pure, the cameras are behind a function.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/camera_pair.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// Peaks of the target's dimmest and brightest LED in one camera, in units of clip: led_peak_from_luma.
struct SeenPeaks {
  double dimmest = 0.0;
  double brightest = 0.0;
};

/// What one setting shows; absent: not exactly the target's LEDs.
struct Look {
  ExposureSetting setting;
  PerSide<std::optional<SeenPeaks>> peaks;
  PerSide<std::size_t> spots{0, 0};
  PerSide<double> mean_luma{0.0, 0.0};  ///< of the whole picture
};

using LookAt = std::function<Result<Look>(const ExposureSetting& setting)>;

/// The exposures for which no LED at one place is below, and none above the recommended range (1 to 3 times clip), with
/// the gain of `look`.
struct PlaceBounds {
  double shortest_us = 0.0;  ///< shorter, and the dimmest LED in one of the cameras is below
  double longest_us = 0.0;   ///< longer, and the brightest is above
  Look look;                 ///< the last one, near to what is recommended
};

/// Looks until the target's LEDs are seen in both cameras and are near the middle of the recommended range. Light is
/// proportional to the exposure; a camera with a display's gamma only takes more steps. The gain is raised only where
/// the longest exposure is too short, and no more than needed.
///
/// @param start  where to begin; the gain is not lowered
/// @return kTimeout, naming camera and range, when the target is never seen in both; kOutOfRange when there the whole
///   picture is lighter than a white surface should be; errors of `look_at`
Result<PlaceBounds> bounds_at_place(const LookAt& look_at, const ExposureOffer& offered, const ExposureSetting& start);

/// The exposure with the same distance to both bounds, as a factor, within what is offered.
///
/// @param near_end, far_end  found with the same gain
/// @return kOutOfRange, with the reason and what to do, when none suits both places
Result<ExposureSetting> exposure_for(const PlaceBounds& near_end, const PlaceBounds& far_end,
                                     const ExposureOffer& offered);

}  // namespace tripoint
