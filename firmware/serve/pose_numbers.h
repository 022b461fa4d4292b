// A pose as the numbers that clients read: position, angles, quaternion, rotation vector, expanded uncertainties.
#pragma once

#include <optional>

#include "line/measurement.h"
#include "values/linear.h"

namespace tripoint {

struct Orientation {
  Vec3 abc_rad = Vec3::Zero();  ///< R = Rz(A) Ry(B) Rx(C)
  Eigen::Vector4d quaternion_wxyz = Eigen::Vector4d::UnitX();
  Vec3 rotation_vector_rad = Vec3::Zero();
  std::optional<double> expanded_a_rad;  ///< k = 2; absent in gimbal lock, where A and C cannot be told apart
  double expanded_b_rad = 0.0;
  std::optional<double> expanded_c_rad;
  bool gimbal_lock = false;
};

struct PoseNumbers {
  Vec3 position_mm = Vec3::Zero();
  Vec3 expanded_mm = Vec3::Zero();  ///< k = 2 per axis
  std::optional<Orientation> orientation;
};

/// @param output_from_target a rotation
/// @param covariance_rad2 of a rotation vector applied on the left, in the output frame
/// @return nothing when a number is not finite or a variance negative
/// Source: paper Eq. 16, corrected; gimbal lock when hypot(Xx, Xy) < 1e-9
std::optional<Orientation> orientation_of(const Matrix3& output_from_target, const Matrix3& covariance_rad2);

/// @return nothing when the position or its uncertainty is not a finite number that a register can hold; a pose
///         without orientation when only the orientation is not
std::optional<PoseNumbers> numbers_of(const TargetPose& pose);

}  // namespace tripoint
