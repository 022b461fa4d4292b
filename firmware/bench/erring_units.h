// Units that know their cameras and their target as badly as they say.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "geometry/rig.h"
#include "line/align/align.h"
#include "line/model.h"
#include "sim/target_view.h"
#include "values/linear.h"

namespace tripoint::bench {

/// Standard deviations of what a pose is made from. The line is told all of them.
struct ErrorSources {
  double spot_px = 0.05;
  double target_mm = 0.025;     ///< of each LED's place in the target, along each axis
  double datum_mm = 0.1;        ///< of a datum's place, likewise
  double calibration_px = 0.1;  ///< of the points in the pictures of a board and a wand (adjustment_covariance)
};

/// 600 x 600 mm, 150 to 800 mm before the cameras.
LineModel model_of(std::span<const Vec3> leds_mm, const StereoCalibration& calibration, const RigCovariance& spread,
                   double target_mm);

/// Draws units with calibrations and targets in error.
class ErringUnits {
 public:
  ErringUnits(const StereoCalibration& truth, const ErrorSources& sources);

  /// What a unit believes, its calibration drawn.
  LineModel model(std::span<const Vec3> leds_mm, std::mt19937_64& random) const;
  /// A target as it was made.
  std::vector<Vec3> target(std::span<const Vec3> leds_mm, std::mt19937_64& random) const;

 private:
  StereoCalibration truth_;
  ErrorSources sources_;
  RigCovariance covariance_ = RigCovariance::Zero();
  RigParameters scale_ = RigParameters::Zero();
  RigCovariance root_ = RigCovariance::Zero();
};

/// At one moment, as if the cameras exposed together.
Aligned as_seen(const TargetView& view, double sigma_px);

}  // namespace tripoint::bench
