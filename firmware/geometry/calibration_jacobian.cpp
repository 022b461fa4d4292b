#include <Eigen/LU>

#include "geometry/rays.h"
#include "geometry/triangulation.h"
#include "values/assert.h"

namespace tripoint {
namespace {

using Pixels = Eigen::Vector4d;  // left u v, right u v
using PixelsByPoint = Eigen::Matrix<double, 4, 3>;
using PixelsByParameters = Eigen::Matrix<double, 4, 24>;

constexpr int kCameraParameters = 9;
constexpr int kFirstPoseParameter = 2 * kCameraParameters;
// Central differences err by step^2 (truncation) and 1e-13 px / step (rounding): these sizes balance both.
constexpr double kRotationStepRad = 1e-5;
constexpr double kTranslationStepMm = 1e-3;

NormalizedPoint direction_of(const Vec3& point_in_camera) {
  return {point_in_camera.x() / point_in_camera.z(), point_in_camera.y() / point_in_camera.z()};
}

/// The best point, or the midpoint where the iteration does not settle: near enough to linearise at.
Vec3 point_to_linearise_at(const Rig& rig, const PerSide<MeasuredPixel>& seen) {
  const Result<TriangulatedPoint> best = triangulated(rig, seen, 0.0);
  if (best) return best->in_rig_mm;
  const Result<PerSide<Ray>> rays = rays_of(rig, {seen.left.at, seen.right.at});
  TRIPOINT_ASSERT(rays.has_value());
  return midpoint_in_rig_mm(*rays);
}

Pixels predicted(const Rig& rig, const Vec3& point_in_rig) {
  const RawPixel left = distorted(rig.cameras.left, direction_of(rig.camera_from_rig.left * point_in_rig));
  const RawPixel right = distorted(rig.cameras.right, direction_of(rig.camera_from_rig.right * point_in_rig));
  return {left.u_px, left.v_px, right.u_px, right.v_px};
}

/// d(pixel)/d(fx fy cx cy k1 k2 p1 p2 k3) of one camera.
Eigen::Matrix<double, 2, kCameraParameters> pixel_by_camera(const CameraModel& camera, const NormalizedPoint& at) {
  const double fx = camera.focal_px.x();
  const double fy = camera.focal_px.y();
  const RawPixel pixel = distorted(camera, at);
  const double r2 = at.x * at.x + at.y * at.y;
  const double xy2 = 2.0 * at.x * at.y;
  const double on_x = fx * at.x * r2;
  const double on_y = fy * at.y * r2;
  Eigen::Matrix<double, 2, kCameraParameters> by;
  by << (pixel.u_px - camera.center_px.x()) / fx, 0.0, 1.0, 0.0, on_x, on_x * r2, fx * xy2,
      fx * (r2 + 2.0 * at.x * at.x), on_x * r2 * r2,  //
      0.0, (pixel.v_px - camera.center_px.y()) / fy, 0.0, 1.0, on_y, on_y * r2, fy * (r2 + 2.0 * at.y * at.y), fy * xy2,
      on_y * r2 * r2;
  return by;
}

Pixels pixels_with(const StereoCalibration& calibration, int parameter, double change, const Vec3& point_in_rig) {
  RigParameters parameters = parameters_of(calibration);
  parameters[parameter] += change;
  const Result<Rig> rig = rig_of(calibration_of(parameters, {}));
  TRIPOINT_ASSERT(rig.has_value());
  return predicted(*rig, point_in_rig);
}

PixelsByParameters pixels_by_parameters(const StereoCalibration& calibration, const Rig& rig, const Vec3& point) {
  PixelsByParameters by = PixelsByParameters::Zero();
  by.block<2, kCameraParameters>(0, 0) =
      pixel_by_camera(rig.cameras.left, direction_of(rig.camera_from_rig.left * point));
  by.block<2, kCameraParameters>(2, kCameraParameters) =
      pixel_by_camera(rig.cameras.right, direction_of(rig.camera_from_rig.right * point));
  for (int i = 0; i < 6; ++i) {
    const double step = i < 3 ? kRotationStepRad : kTranslationStepMm;
    const int parameter = kFirstPoseParameter + i;
    by.col(parameter) =
        (pixels_with(calibration, parameter, step, point) - pixels_with(calibration, parameter, -step, point)) /
        (2.0 * step);
  }
  return by;
}

PixelsByPoint pixels_by_point(const Rig& rig, const Vec3& point) {
  PixelsByPoint by;
  const Isometry3& left = rig.camera_from_rig.left;
  const Isometry3& right = rig.camera_from_rig.right;
  by.topRows<2>() = projection_jacobian_px_per_mm(rig.cameras.left, left * point) * left.linear();
  by.bottomRows<2>() = projection_jacobian_px_per_mm(rig.cameras.right, right * point) * right.linear();
  return by;
}

}  // namespace

Eigen::Matrix<double, 3, 24> calibration_jacobian(const StereoCalibration& calibration,
                                                  const PerSide<MeasuredPixel>& seen) {
  const Result<Rig> rig = rig_of(calibration);
  TRIPOINT_ASSERT(rig.has_value());
  const Vec3 point = point_to_linearise_at(*rig, seen);
  const PixelsByPoint by_point = pixels_by_point(*rig, point);
  Eigen::Matrix<double, 3, 4> weighted;
  weighted.leftCols<2>() = by_point.topRows<2>().transpose() * seen.left.covariance_px2.inverse();
  weighted.rightCols<2>() = by_point.bottomRows<2>().transpose() * seen.right.covariance_px2.inverse();
  const Matrix3 information = weighted * by_point;
  // At the least error J' W (seen - predicted) = 0; with the pixels held, a change of prediction moves the point back.
  return -(information.inverse() * weighted) * pixels_by_parameters(calibration, *rig, point);
}

Eigen::Matrix<double, 4, 24> pixels_by_calibration(const StereoCalibration& calibration, const Vec3& point_in_rig_mm) {
  const Result<Rig> rig = rig_of(calibration);
  TRIPOINT_ASSERT(rig.has_value());
  return pixels_by_parameters(calibration, *rig, point_in_rig_mm);
}

}  // namespace tripoint
