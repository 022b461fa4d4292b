#include "serve/pose_numbers.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kCoverage = 2.0;            // k, 95 % per axis
constexpr double kGimbalLock = 1e-9;         // cosine of B below which A and C turn about the same axis
constexpr double kLargestPosition_mm = 2e6;  // a signed 32-bit number of um ends at 2147 m

bool usable_variances(const Vec3& variances) { return variances.allFinite() && variances.minCoeff() >= 0.0; }

/// The quaternion with w >= 0; of the two at w = 0, the one whose first other number is positive.
Eigen::Vector4d quaternion_of(const Matrix3& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  const Eigen::Vector4d wxyz(q.w(), q.x(), q.y(), q.z());
  for (const double number : wxyz) {
    if (number != 0.0) return number < 0.0 ? Eigen::Vector4d(-wxyz) : wxyz;
  }
  return wxyz;
}

Vec3 rotation_vector_of(const Eigen::Vector4d& wxyz) {
  const Vec3 sine_part = wxyz.tail<3>();
  const double sine = sine_part.norm();
  if (sine == 0.0) return Vec3::Zero();
  return sine_part * (2.0 * std::atan2(sine, wxyz[0]) / sine);
}

double expanded(const Vec3& direction, const Matrix3& covariance) {
  return kCoverage * std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
}

Orientation angles_of(const Matrix3& rotation) {
  const Vec3 x = rotation.col(0);
  const Vec3 y = rotation.col(1);
  Orientation found;
  const double cosine_b = std::hypot(x.x(), x.y());
  found.gimbal_lock = cosine_b < kGimbalLock;
  const double a = found.gimbal_lock ? std::atan2(-y.x(), y.y()) : std::atan2(x.y(), x.x());
  const double b = std::atan2(-x.z(), cosine_b);
  const double c = found.gimbal_lock ? 0.0 : std::atan2(y.z(), rotation(2, 2));
  found.abc_rad = Vec3(a, b, c);
  return found;
}

}  // namespace

std::optional<Orientation> orientation_of(const Matrix3& output_from_target, const Matrix3& covariance_rad2) {
  if (!output_from_target.allFinite() || !covariance_rad2.allFinite()) return std::nullopt;
  if (!usable_variances(covariance_rad2.diagonal())) return std::nullopt;
  Orientation found = angles_of(output_from_target);
  found.quaternion_wxyz = quaternion_of(output_from_target);
  found.rotation_vector_rad = rotation_vector_of(found.quaternion_wxyz);
  const double a = found.abc_rad[0];
  const double b = found.abc_rad[1];
  // A small rotation w moves the angles by dB = w.(z x level), dC = w.level / cos B, dA = w.z + tan B (w.level).
  const Vec3 level(std::cos(a), std::sin(a), 0.0);
  found.expanded_b_rad = expanded(Vec3(-std::sin(a), std::cos(a), 0.0), covariance_rad2);
  if (!found.gimbal_lock) {
    found.expanded_a_rad = expanded(Vec3::UnitZ() + std::tan(b) * level, covariance_rad2);
    found.expanded_c_rad = expanded(level / std::cos(b), covariance_rad2);
  }
  return found;
}

std::optional<PoseNumbers> numbers_of(const TargetPose& pose) {
  const Matrix6 covariance = pose.noise + pose.shared;
  const Vec3 variances = covariance.diagonal().head<3>();
  const Vec3& position = pose.position_in_output_mm;
  if (!position.allFinite() || position.cwiseAbs().maxCoeff() > kLargestPosition_mm) return std::nullopt;
  if (!usable_variances(variances)) return std::nullopt;
  PoseNumbers numbers;
  numbers.position_mm = position;
  numbers.expanded_mm = kCoverage * variances.cwiseSqrt();
  if (pose.output_from_target) {
    numbers.orientation = orientation_of(*pose.output_from_target, covariance.bottomRightCorner<3, 3>());
  }
  return numbers;
}

}  // namespace tripoint
