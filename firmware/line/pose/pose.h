// From pairs of image points to points in space, and to the target's place.
#pragma once

#include <optional>

#include "line/match/match.h"
#include "line/measurement.h"
#include "line/model.h"
#include "values/fixed_vector.h"

namespace tripoint {

/// What could be measured, before the gates.
struct Fit {
  FixedVector<MeasuredPoint, kMaxTargetPoints> points;
  std::optional<TargetPose> pose;
  Faults faults;
  double residual_rms_px = 0.0;
  double timing_sigma_mm = 0.0;  ///< the clocks' part of the pose's standard deviation, all directions together
  std::optional<double> uncorrected_cost_mm;  ///< how far the skew would have moved the pose, taken as none
};

/// Every pair becomes a point in the output frame; the identified point of a one-point target is its position.
///
/// @return kGeometryGate when a pair's rays do not meet in front of both cameras at a usable angle
Fit pose_of_target(const Aligned& seen, const Pairs& pairs, const LineModel& model);

}  // namespace tripoint
