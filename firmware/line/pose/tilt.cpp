#include "line/pose/tilt.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kSigmas = 4.0;

/// Leaves alone what lies across the direction, which has unit length.
Matrix3 mirror(const Vec3& direction) { return Matrix3::Identity() - 2.0 * direction * direction.transpose(); }

}  // namespace

Isometry3 tilted_over(const Isometry3& rig_from_target, std::span<const Vec3> in_target_mm) {
  Vec3 middle_mm = Vec3::Zero();
  for (const Vec3& point : in_target_mm) middle_mm += point / static_cast<double>(in_target_mm.size());
  Matrix3 scatter_mm2 = Matrix3::Zero();
  for (const Vec3& point : in_target_mm) scatter_mm2 += (point - middle_mm) * (point - middle_mm).transpose();
  const Vec3 across = Eigen::SelfAdjointEigenSolver<Matrix3>(scatter_mm2).eigenvectors().col(0);
  const Vec3 middle_in_rig_mm = rig_from_target * middle_mm;
  Isometry3 over = Isometry3::Identity();
  over.linear() = mirror(middle_in_rig_mm.normalized()) * rig_from_target.linear() * mirror(across);
  over.translation() = middle_in_rig_mm - over.linear() * middle_mm;
  return over;
}

double turn_between_rad(const Isometry3& one, const Isometry3& other) {
  return Eigen::AngleAxisd(one.linear().transpose() * other.linear()).angle();
}

double reach_of_tilt_rad(const Isometry3& tilt, const Isometry3& other, const Matrix3& turn_covariance_rad2) {
  return std::max(0.5 * turn_between_rad(tilt, other), kSigmas * std::sqrt(turn_covariance_rad2.trace()));
}

}  // namespace tripoint
