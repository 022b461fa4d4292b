#include "geometry/rig.h"

#include <cmath>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr double kLeastBaselineMm = 1e-3;
constexpr double kLeastForward = 1e-3;  // length of the summed axes' part across the baseline; 2 for a common rig

constexpr int kCameraParameters = 9;
constexpr int kFirstPoseParameter = 2 * kCameraParameters;
constexpr double kRotationStep_rad = 1e-5;
constexpr double kTranslationStep_mm = 1e-3;

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
  parameters.segment<3>(kFirstPoseParameter) = rotation.angle() * rotation.axis();
  parameters.segment<3>(kFirstPoseParameter + 3) = calibration.right_from_left.translation();
  return parameters;
}

StereoCalibration calibration_of(const RigParameters& parameters, const PerSide<ImageSize>& sizes) {
  StereoCalibration calibration;
  calibration.cameras.left = camera_from(parameters, 0, sizes.left);
  calibration.cameras.right = camera_from(parameters, kCameraParameters, sizes.right);
  const Vec3 rotation = parameters.segment<3>(kFirstPoseParameter);
  const double angle = rotation.norm();
  if (angle > 0.0) {
    calibration.right_from_left.linear() = Eigen::AngleAxisd{angle, rotation / angle}.toRotationMatrix();
  }
  calibration.right_from_left.translation() = parameters.segment<3>(kFirstPoseParameter + 3);
  return calibration;
}

Eigen::Matrix<double, 6, 24> left_from_rig_by_calibration(const StereoCalibration& calibration) {
  const RigParameters parameters = parameters_of(calibration);
  const auto left_from_rig = [&](int parameter, double change) {
    RigParameters changed = parameters;
    changed[parameter] += change;
    const Result<Rig> rig = rig_of(calibration_of(changed, {}));
    TRIPOINT_ASSERT(rig.has_value());
    return rig->camera_from_rig.left;
  };
  Eigen::Matrix<double, 6, 24> by_calibration = Eigen::Matrix<double, 6, 24>::Zero();
  for (int parameter = kFirstPoseParameter; parameter < parameters.size(); ++parameter) {
    const double step = parameter < kFirstPoseParameter + 3 ? kRotationStep_rad : kTranslationStep_mm;
    const Isometry3 before = left_from_rig(parameter, -step);
    const Isometry3 after = left_from_rig(parameter, step);
    const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
    by_calibration.col(parameter) << after.translation() - before.translation(), turn.angle() * turn.axis();
    by_calibration.col(parameter) /= 2.0 * step;
  }
  return by_calibration;
}

double baseline_mm(const Rig& rig) {
  return (rig.camera_from_rig.right * rig.camera_from_rig.left.inverse()).translation().norm();
}

Matrix3 essential_matrix(const Rig& rig) {
  const Isometry3 left_from_right = rig.camera_from_rig.left * rig.camera_from_rig.right.inverse();
  return cross_product_matrix(left_from_right.translation()) * left_from_right.linear();
}

}  // namespace tripoint
