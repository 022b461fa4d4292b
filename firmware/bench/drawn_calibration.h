// Calibrations as they come out of a board and a wand: the truth plus an error with the right correlations.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/rig.h"
#include "values/linear.h"

namespace tripoint::bench {

/// Covariance of the 24 parameters after a joint adjustment of 40 views of a chessboard (9 x 6 corners, 24 mm, tilted
/// 20 to 45 degrees, 300 to 500 mm away) and 500 frames of a wand (LEDs at 0, 80, 200 mm, any direction), each point
/// seen by both cameras with `sigma_px`: the inverse Fisher information with all poses eliminated.
/// Source: Triggs et al. 2000, "Bundle Adjustment - A Modern Synthesis", section 6.
RigCovariance adjustment_covariance(const StereoCalibration& truth, double sigma_px, std::uint64_t seed);

/// A calibration in error, and the rigid motion that registration to the truth finds.
struct DrawnCalibration {
  StereoCalibration calibration;
  Rig rig;
  Isometry3 truth_from_drawn = Isometry3::Identity();
  double field_rms_mm = 0.0;  ///< error of noise-free points after that motion
};

/// `count` calibrations drawn from the covariance, which is scaled so that the RMS of their error fields over `places`
/// is `field_rms_mm`.
std::vector<DrawnCalibration> drawn_calibrations(const StereoCalibration& truth, const RigCovariance& covariance,
                                                 const std::vector<Vec3>& places_mm, double field_rms_mm, int count);

}  // namespace tripoint::bench
