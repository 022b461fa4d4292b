// The two cameras and where they sit in the reference frame.
#pragma once

#include "geometry/camera_model.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

/// Parameters of a calibration, in the order of its covariance: left fx fy cx cy k1 k2 p1 p2 k3, right the
/// same, rotation vector (rad) and translation (mm) of right_from_left.
using RigParameters = Eigen::Matrix<double, 24, 1>;
using RigCovariance = Eigen::Matrix<double, 24, 24>;

/// What a calibration says, before a reference frame is chosen.
struct StereoCalibration {
  PerSide<CameraModel> cameras;
  Isometry3 right_from_left = Isometry3::Identity();
};

/// The reference frame (`rig`): origin midway between the lens centres; x from the left centre to the right;
/// z the sum of both optical axes less its part along x; y = z cross x (down).
struct Rig {
  PerSide<CameraModel> cameras;
  PerSide<Isometry3> camera_from_rig{Isometry3::Identity(), Isometry3::Identity()};
};

/// The rig of a calibration.
///
/// @return kDegenerate when the lens centres coincide or the optical axes cancel or lie along the baseline
Result<Rig> rig_of(const StereoCalibration& calibration);

RigParameters parameters_of(const StereoCalibration& calibration);

/// The inverse of parameters_of; picture sizes are taken from `sizes`.
StereoCalibration calibration_of(const RigParameters& parameters, const PerSide<ImageSize>& sizes);

/// d(camera_from_rig.left) / d(calibration parameters): its translation, mm, and rotation vector along the camera's
/// axes, rad. The reference frame moves with the parameters, the camera does not. Central differences (steps 1e-5 rad,
/// 1e-3 mm). The calibration must have a rig.
Eigen::Matrix<double, 6, 24> left_from_rig_by_calibration(const StereoCalibration& calibration);

/// Distance between the lens centres.
double baseline_mm(const Rig& rig);

/// Maps directions so that left' E right = 0 holds for matching normalized points (left as row vector).
Matrix3 essential_matrix(const Rig& rig);

}  // namespace tripoint
