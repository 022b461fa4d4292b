#include "sim/default_rig.h"

namespace tripoint {
namespace {

constexpr ImageSize kFullSize{.width_px = 640, .height_px = 480};

/// Pixel centres are at integers, so the corner of the picture is at -0.5.
CameraModel scaled(CameraModel camera, ImageSize size) {
  const double scale = static_cast<double>(size.width_px) / kFullSize.width_px;
  const double cut_px = (scale * kFullSize.height_px - size.height_px) / 2.0;
  camera.focal_px *= scale;
  camera.center_px = (camera.center_px.array() + 0.5) * scale - 0.5;
  camera.center_px.y() -= cut_px;
  camera.size = size;
  return camera;
}

}  // namespace

StereoCalibration default_rig(ImageSize size) {
  StereoCalibration calibration;
  calibration.cameras.left = scaled({.size = kFullSize,
                                     .focal_px = {628.0, 628.6},
                                     .center_px = {322.3, 237.8},
                                     .distortion = {-0.30, 0.10, 5e-4, -3e-4, 0.0}},
                                    size);
  calibration.cameras.right = scaled({.size = kFullSize,
                                      .focal_px = {626.1, 626.7},
                                      .center_px = {317.1, 243.5},
                                      .distortion = {-0.28, 0.09, -4e-4, 6e-4, 0.0}},
                                     size);
  const Vec3 rotation_rad(0.006981317007977318, 0.17453292519943295, 0.012217304763960306);
  calibration.right_from_left.linear() =
      Eigen::AngleAxisd(rotation_rad.norm(), rotation_rad.normalized()).toRotationMatrix();
  calibration.right_from_left.translation() = Vec3(-99.6, 0.2, 8.7);
  return calibration;
}

}  // namespace tripoint
