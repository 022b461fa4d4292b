// Whether two image points can be one point in space: the epipolar gate.
#pragma once

#include <optional>

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "line/model.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

/// d(epipolar distance, px) / d(calibration parameters) at a pair of raw pixels, analytic.
///
/// The distance is that of epipolar_error, its normalisation taken as constant (first order near the epipolar plane).
/// @return nothing when a pixel cannot be undistorted
std::optional<RigParameters> epipolar_calibration_gradient(const StereoCalibration& calibration,
                                                           const PerSide<RawPixel>& pixels);

struct EpipolarGate {
  double distance_px = 0.0;
  double noise_px2 = 0.0;  ///< variance, from the image points alone
  double sigma_px = 0.0;   ///< standard deviation, from the image points and the calibration
  bool passed = false;
};

/// Distance of a pair from a common epipolar plane against `limits.epipolar_sigmas` of its standard deviation.
///
/// @return nothing when a pixel cannot be undistorted
std::optional<EpipolarGate> epipolar_gate(const LineModel& model, const PerSide<MeasuredPixel>& seen);

}  // namespace tripoint
