// The frame in which poses are given, and how it moves with the calibration.
#pragma once

#include "line/measurement.h"
#include "line/model.h"
#include "values/linear.h"

namespace tripoint {

/// Has a model give its poses in the reference frame or in that of the left camera. The working volume stays where it
/// is.
///
/// @param frame  one of these two
/// @param model  with its calibration and rig
void give_poses_in(OutputFrame frame, LineModel& model);

/// d(place in output, mm) / d(calibration parameters).
///
/// @param in_rig  how the place in the rig follows them
Eigen::Matrix<double, 3, 24> place_in_output_by(const Eigen::Matrix<double, 3, 24>& in_rig, const Vec3& place_in_rig_mm,
                                                const LineModel& model);

/// The same of a pose: position, and rotation vector in the frame's directions, rad.
Eigen::Matrix<double, 6, 24> pose_in_output_by(const Eigen::Matrix<double, 6, 24>& in_rig,
                                               const Vec3& position_in_rig_mm, const LineModel& model);

}  // namespace tripoint
