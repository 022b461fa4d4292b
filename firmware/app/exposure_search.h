// Which exposure suits a target at both ends of the working volume: pure, the cameras are behind a function.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// Peaks of the target's dimmest and brightest LED in one camera, in units of clip: led_peak_from_luma.
struct SeenPeaks {
  double dimmest = 0.0;
  double brightest = 0.0;
};

/// What one exposure shows; absent: not exactly the target's LEDs.
struct Look {
  std::chrono::microseconds exposure{0};
  PerSide<std::optional<SeenPeaks>> peaks;
  PerSide<std::size_t> spots{0, 0};
  PerSide<double> mean_luma{0.0, 0.0};  ///< of the whole picture
};

using LookAt = std::function<Result<Look>(std::chrono::microseconds exposure)>;

struct ExposureRange {
  std::chrono::microseconds shortest{0};
  std::chrono::microseconds longest{0};
};

/// The exposures for which no LED at one place is below, and none above the recommended range (1 to 3 times clip).
struct PlaceBounds {
  double shortest_us = 0.0;  ///< shorter, and the dimmest LED in one of the cameras is below
  double longest_us = 0.0;   ///< longer, and the brightest is above
  Look look;                 ///< the last one, near to what is recommended
};

/// Looks until the target's LEDs are seen in both cameras and are near the middle of the recommended range. Light is
/// proportional to the exposure; a camera with a display's gamma only takes more steps.
///
/// @param start  where to begin
/// @return kTimeout, naming camera and range, when the target is never seen in both; kOutOfRange when there the whole
///   picture is lighter than a white surface should be; errors of `look_at`
Result<PlaceBounds> bounds_at_place(const LookAt& look_at, const ExposureRange& offered,
                                    std::chrono::microseconds start);

/// The exposure with the same distance to both bounds, as a factor, within what is offered.
///
/// @return kOutOfRange, with the reason and what to do, when none suits both places
Result<std::chrono::microseconds> exposure_for(const PlaceBounds& near_end, const PlaceBounds& far_end,
                                               const ExposureRange& offered);

}  // namespace tripoint
