#include "geometry/camera_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace tripoint {
namespace {

constexpr int kNewtonSteps = 30;  // undamped it needs 3 to 6; near the edge of the domain steps are halved
constexpr int kHalvings = 12;
constexpr double kSettled = 4.0 * std::numeric_limits<double>::epsilon();
constexpr double kAccepted = 1e-13;  // residual on the plane z = 1; 6e-11 px at a focal length of 628 px
// Where the distortion squeezes the picture a hundredfold, a pixel no longer tells a direction.
constexpr double kLeastStretch = 0.01;

double radial_factor(const CameraModel& camera, double r2) {
  return 1.0 + r2 * (camera.distortion[0] + r2 * (camera.distortion[1] + r2 * camera.distortion[4]));
}

Vec2 distorted_on_plane(const CameraModel& camera, const Vec2& p) {
  const double r2 = p.squaredNorm();
  const double p1 = camera.distortion[2];
  const double p2 = camera.distortion[3];
  const double xy2 = 2.0 * p.x() * p.y();
  return radial_factor(camera, r2) * p +
         Vec2{p1 * xy2 + p2 * (r2 + 2.0 * p.x() * p.x()), p2 * xy2 + p1 * (r2 + 2.0 * p.y() * p.y())};
}

Matrix2 jacobian_on_plane(const CameraModel& camera, const Vec2& p) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const double r2 = p.squaredNorm();
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // d(factor)/d(r2), doubled: dr2/dx = 2x
  Matrix2 jacobian = radial_factor(camera, r2) * Matrix2::Identity() + slope * p * p.transpose();
  const double mixed = 2.0 * (p1 * p.x() + p2 * p.y());
  jacobian(0, 0) += 2.0 * p1 * p.y() + 6.0 * p2 * p.x();
  jacobian(0, 1) += mixed;
  jacobian(1, 0) += mixed;
  jacobian(1, 1) += 6.0 * p1 * p.y() + 2.0 * p2 * p.x();
  return jacobian;
}

/// d(distorted radius)/d(radius), tangential part left out, as a function of the squared radius.
double radial_stretch(const CameraModel& camera, double r2) {
  return 1.0 + r2 * (3.0 * camera.distortion[0] + r2 * (5.0 * camera.distortion[1] + r2 * 7.0 * camera.distortion[4]));
}

/// Whether the picture grows with the angle all the way from the centre to `r2`: beyond a fold of the
/// polynomial a second direction has the same pixel.
bool unfolded_up_to(const CameraModel& camera, double r2) {
  if (radial_stretch(camera, r2) < kLeastStretch) return false;
  // Extrema of the stretch: 3 k1 + 10 k2 s + 21 k3 s^2 = 0.
  const double a = 21.0 * camera.distortion[4];
  const double b = 10.0 * camera.distortion[1];
  const double c = 3.0 * camera.distortion[0];
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return true;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const auto clear_at = [&](double numerator, double denominator) {
    const double s = numerator / denominator;  // infinite or NaN when the equation has no such root
    return !(s > 0.0 && s < r2) || radial_stretch(camera, s) >= kLeastStretch;
  };
  return clear_at(q, a) && clear_at(c, q);
}

Vec2 on_distorted_plane(const CameraModel& camera, const RawPixel& pixel) {
  return {(pixel.u_px - camera.center_px.x()) / camera.focal_px.x(),
          (pixel.v_px - camera.center_px.y()) / camera.focal_px.y()};
}

struct Iterate {
  Vec2 point;
  Vec2 residual;
};

/// One Newton step, halved until the residual shrinks.
Iterate improved(const CameraModel& camera, const Vec2& target, const Iterate& from) {
  const Vec2 step = jacobian_on_plane(camera, from.point).inverse() * from.residual;
  double share = 1.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const Vec2 point = from.point + share * step;
    const Vec2 residual = target - distorted_on_plane(camera, point);
    if (residual.squaredNorm() < from.residual.squaredNorm()) return {point, residual};
    share *= 0.5;
  }
  return from;
}

}  // namespace

RawPixel distorted(const CameraModel& camera, const NormalizedPoint& point) {
  const Vec2 p = distorted_on_plane(camera, {point.x, point.y});
  return {camera.focal_px.x() * p.x() + camera.center_px.x(), camera.focal_px.y() * p.y() + camera.center_px.y()};
}

Matrix2 distortion_jacobian_px(const CameraModel& camera, const NormalizedPoint& point) {
  return camera.focal_px.asDiagonal() * jacobian_on_plane(camera, {point.x, point.y});
}

Result<NormalizedPoint> undistorted(const CameraModel& camera, const RawPixel& pixel) {
  const Vec2 target = on_distorted_plane(camera, pixel);
  Iterate now{target, target - distorted_on_plane(camera, target)};
  const double scale = 1.0 + target.norm();
  for (int step = 0; step < kNewtonSteps && now.residual.norm() > kSettled * scale; ++step) {
    const Iterate next = improved(camera, target, now);
    if (next.point == now.point) break;
    now = next;
  }
  // Written so that NaN, which compares false, is refused as well.
  const bool inside = now.residual.norm() <= kAccepted * scale && unfolded_up_to(camera, now.point.squaredNorm()) &&
                      jacobian_on_plane(camera, now.point).determinant() > kLeastStretch * kLeastStretch;
  if (!inside) return failure(ErrorCode::kNoConvergence);
  return NormalizedPoint{now.point.x(), now.point.y()};
}

Result<RawPixel> projected(const CameraModel& camera, const Vec3& point_in_camera) {
  if (!(point_in_camera.z() > 0.0)) return failure(ErrorCode::kBehindCamera);
  return distorted(camera, {point_in_camera.x() / point_in_camera.z(), point_in_camera.y() / point_in_camera.z()});
}

Matrix23 projection_jacobian_px_per_mm(const CameraModel& camera, const Vec3& point_in_camera) {
  const double z = point_in_camera.z();
  const NormalizedPoint at{point_in_camera.x() / z, point_in_camera.y() / z};
  Matrix23 perspective;
  perspective << 1.0 / z, 0.0, -at.x / z, 0.0, 1.0 / z, -at.y / z;
  return distortion_jacobian_px(camera, at) * perspective;
}

}  // namespace tripoint
