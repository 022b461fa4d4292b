#include "geometry/rig.h"

#include <cmath>

namespace tripoint {
namespace {

constexpr double kLeastBaselineMm = 1e-3;
constexpr double kLeastForward = 1e-3;  // length of the summed axes' part across the baseline; 2 for a common rig

constexpr int kCameraParameters = 9;

void put_camera(RigParameters& parameters, int first, const CameraModel& camera) {
  parameters.segment<2>(first) = camera.focal_px;
  parameters.segment<2>(first + 2) = camera.center_px;
  for (int i = 0; i < 5; ++i) parameters[first + 4 + i] = camera.distortion[static_cast<std::size_t>(i)];
}

CameraModel camera_from(const RigParameters& parameters, int first, ImageSize size) {
  CameraModel camera{size, parameters.segment<2>(first), parameters.segment<2>(first + 2), {}};
  for (int i = 0; i < 5; ++i) camera.distortion[static_cast<std::size_t>(i)] = parameters[first + 4 + i];
  return camera;
}

Matrix3 cross_product_matrix(const Vec3& v) {
  Matrix3 matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

}  // namespace

Result<Rig> rig_of(const StereoCalibration& calibration) {
  const Isometry3 left_from_right = calibration.right_from_left.inverse();
  const Vec3 right_center_in_left = left_from_right.translation();
  const double baseline = right_center_in_left.norm();
  if (!(baseline > kLeastBaselineMm)) return failure(ErrorCode::kDegenerate, "the lens centres coincide");
  const Vec3 x = right_center_in_left / baseline;
  const Vec3 axes = Vec3::UnitZ() + left_from_right.linear().col(2);
  const Vec3 forward = axes - axes.dot(x) * x;
  if (!(forward.norm() > kLeastForward)) {
    return failure(ErrorCode::kDegenerate, "the optical axes cancel or lie along the baseline");
  }
  const Vec3 z = forward.normalized();

  Isometry3 left_from_rig = Isometry3::Identity();
  left_from_rig.linear() << x, z.cross(x), z;
  left_from_rig.translation() = 0.5 * right_center_in_left;
  return Rig{calibration.cameras, {left_from_rig, calibration.right_from_left * left_from_rig}};
}

RigParameters parameters_of(const StereoCalibration& calibration) {
  RigParameters parameters;
  put_camera(parameters, 0, calibration.cameras.left);
  put_camera(parameters, kCameraParameters, calibration.cameras.right);
  const Eigen::AngleAxisd rotation{calibration.right_from_left.linear()};
  parameters.segment<3>(2 * kCameraParameters) = rotation.angle() * rotation.axis();
  parameters.segment<3>(2 * kCameraParameters + 3) = calibration.right_from_left.translation();
  return parameters;
}

StereoCalibration calibration_of(const RigParameters& parameters, const PerSide<ImageSize>& sizes) {
  StereoCalibration calibration;
  calibration.cameras.left = camera_from(parameters, 0, sizes.left);
  calibration.cameras.right = camera_from(parameters, kCameraParameters, sizes.right);
  const Vec3 rotation = parameters.segment<3>(2 * kCameraParameters);
  const double angle = rotation.norm();
  if (angle > 0.0) {
    calibration.right_from_left.linear() = Eigen::AngleAxisd{angle, rotation / angle}.toRotationMatrix();
  }
  calibration.right_from_left.translation() = parameters.segment<3>(2 * kCameraParameters + 3);
  return calibration;
}

double baseline_mm(const Rig& rig) {
  return (rig.camera_from_rig.right * rig.camera_from_rig.left.inverse()).translation().norm();
}

Matrix3 essential_matrix(const Rig& rig) {
  const Isometry3 left_from_right = rig.camera_from_rig.left * rig.camera_from_rig.right.inverse();
  return cross_product_matrix(left_from_right.translation()) * left_from_right.linear();
}

}  // namespace tripoint
