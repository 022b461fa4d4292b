// How far a pose is from the truth, in millimetres and in its own stated terms.
#pragma once

#include "geometry/rigid_fit.h"
#include "line/measurement.h"

namespace tripoint::bench {

struct PoseError {
  PoseParameters error = PoseParameters::Zero();  ///< position, mm, and rotation vector, rad, about the output's axes
  Eigen::Index size = 3;                          ///< 3: position alone, 6: orientation too
  double chi2 = 0.0;  ///< of that many degrees of freedom, over noise and calibration together

  [[nodiscard]] double position_mm() const { return error.head<3>().norm(); }
  [[nodiscard]] double angle_rad() const { return error.tail<3>().norm(); }
};

/// @param output_from_target  where it truly is
PoseError pose_error(const TargetPose& measured, const Isometry3& output_from_target);

/// Share of true normal errors that lie further out: chi-square's upper tail.
double tail_beyond(const PoseError& pose);

/// More than 1 mm or 1 degree away, and further than noise goes in one of a million poses: not noise.
bool is_wrong(const PoseError& pose);

}  // namespace tripoint::bench
