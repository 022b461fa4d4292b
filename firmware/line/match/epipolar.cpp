#include "line/match/epipolar.h"

#include <cmath>

#include <Eigen/LU>

namespace tripoint {
namespace {

constexpr double kFarOutside_px = 50.0;  // no calibration error explains that: not worth its covariance

using Matrix29 = Eigen::Matrix<double, 2, 9>;

/// How a rotation vector's change turns the result: R(w + dw) = exp(J dw) R(w).
/// Source: Chirikjian 2012, "Stochastic Models, Information Theory, and Lie Groups 2", eq. 10.86.
Matrix3 left_jacobian(const Vec3& rotation_rad) {
  const double angle = rotation_rad.norm();
  const Matrix3 w = cross_matrix(rotation_rad);
  if (angle < 1e-6) return Matrix3::Identity() + 0.5 * w;
  const double angle2 = angle * angle;
  return Matrix3::Identity() + (1.0 - std::cos(angle)) / angle2 * w +
         (angle - std::sin(angle)) / (angle2 * angle) * w * w;
}

/// d(RawPixel) / d(fx fy cx cy k1 k2 p1 p2 k3) at a viewing direction.
Matrix29 intrinsic_jacobian(const CameraModel& camera, const NormalizedPoint& point) {
  const double fx = camera.focal_px.x();
  const double fy = camera.focal_px.y();
  const RawPixel pixel = distorted(camera, point);
  const double r2 = point.x * point.x + point.y * point.y;
  const double xy2 = 2.0 * point.x * point.y;
  Matrix29 jacobian;
  jacobian << (pixel.u_px - camera.center_px.x()) / fx, 0.0, 1.0, 0.0, fx * point.x * r2, fx * point.x * r2 * r2,
      fx * xy2, fx * (r2 + 2.0 * point.x * point.x), fx * point.x * r2 * r2 * r2,  //
      0.0, (pixel.v_px - camera.center_px.y()) / fy, 0.0, 1.0, fy * point.y * r2, fy * point.y * r2 * r2,
      fy * (r2 + 2.0 * point.y * point.y), fy * xy2, fy * point.y * r2 * r2 * r2;
  return jacobian;
}

Vec3 direction(const NormalizedPoint& point) { return {point.x, point.y, 1.0}; }

}  // namespace

std::optional<RigParameters> epipolar_calibration_gradient(const StereoCalibration& calibration,
                                                           const PerSide<RawPixel>& pixels) {
  const PerSide<CameraModel>& cameras = calibration.cameras;
  const Result<NormalizedPoint> left = undistorted(cameras.left, pixels.left);
  const Result<NormalizedPoint> right = undistorted(cameras.right, pixels.right);
  if (!left || !right) return std::nullopt;

  // constraint e = right . (t x R left); its slopes along raw pixels normalise it to px
  const Matrix3 rotation = calibration.right_from_left.linear();
  const Vec3 t = calibration.right_from_left.translation();
  const Vec3 turned = rotation * direction(*left);
  const Vec3 seen_right = direction(*right);
  const Vec3 left_line = rotation.transpose() * seen_right.cross(t);
  const Vec3 right_line = t.cross(turned);
  const auto slope = [](const CameraModel& camera, const NormalizedPoint& at, const Vec3& line) -> Vec2 {
    return distortion_jacobian_px(camera, at).transpose().inverse() * line.head<2>();
  };
  const Vec2 left_slope = slope(cameras.left, *left, left_line);
  const Vec2 right_slope = slope(cameras.right, *right, right_line);
  const double scale = 1.0 / std::sqrt(left_slope.squaredNorm() + right_slope.squaredNorm());

  RigParameters gradient;
  gradient.segment<9>(0) = -intrinsic_jacobian(cameras.left, *left).transpose() * left_slope;
  gradient.segment<9>(9) = -intrinsic_jacobian(cameras.right, *right).transpose() * right_slope;
  const Eigen::AngleAxisd turn(rotation);
  const Vec3 rotation_rad = turn.angle() * turn.axis();
  gradient.segment<3>(18) = left_jacobian(rotation_rad).transpose() * turned.cross(seen_right.cross(t));
  gradient.segment<3>(21) = turned.cross(seen_right);
  return gradient * scale;
}

std::optional<EpipolarGate> epipolar_gate(const LineModel& model, const PerSide<MeasuredPixel>& seen) {
  const Result<EpipolarError> error = epipolar_error(model.rig, seen);
  if (!error) return std::nullopt;
  double variance_px2 = error->variance_px2;
  if (std::abs(error->distance_px) < kFarOutside_px) {
    const std::optional<RigParameters> gradient =
        epipolar_calibration_gradient(model.calibration, {seen.left.at, seen.right.at});
    if (!gradient) return std::nullopt;
    variance_px2 += gradient->dot(model.covariance.lazyProduct(*gradient));
  }
  const double sigma_px = std::sqrt(variance_px2);
  return EpipolarGate{error->distance_px, error->variance_px2, sigma_px,
                      std::abs(error->distance_px) <= model.limits.epipolar_sigmas * sigma_px};
}

}  // namespace tripoint
