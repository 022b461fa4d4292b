// One camera as a function from directions to pixels: focal lengths, centre, five distortion coefficients.
#pragma once

#include <array>

#include "values/linear.h"
#include "values/pixel.h"
#include "values/result.h"

namespace tripoint {

/// OpenCV's pinhole model; pixel centres at integers. `distortion` is k1 k2 p1 p2 k3.
/// Source: D. C. Brown 1966, "Decentering Distortion of Lenses"; coefficient order as in OpenCV.
struct CameraModel {
  ImageSize size;
  Vec2 focal_px{0.0, 0.0};
  Vec2 center_px{0.0, 0.0};
  std::array<double, 5> distortion{};
};

using Matrix23 = Eigen::Matrix<double, 2, 3>;

/// Where a viewing direction appears in the picture.
RawPixel distorted(const CameraModel& camera, const NormalizedPoint& point);

/// d(RawPixel) / d(NormalizedPoint), in px.
Matrix2 distortion_jacobian_px(const CameraModel& camera, const NormalizedPoint& point);

/// The viewing direction of a pixel, by Newton's method.
///
/// @return kNoConvergence when the pixel lies outside the range in which the distortion can be inverted
Result<NormalizedPoint> undistorted(const CameraModel& camera, const RawPixel& pixel);

/// Projection of a point in the camera frame (mm).
///
/// @return kBehindCamera when z is not positive
Result<RawPixel> projected(const CameraModel& camera, const Vec3& point_in_camera);

/// d(RawPixel) / d(point in the camera frame), px per mm. The point must be in front of the camera.
Matrix23 projection_jacobian_px_per_mm(const CameraModel& camera, const Vec3& point_in_camera);

}  // namespace tripoint
