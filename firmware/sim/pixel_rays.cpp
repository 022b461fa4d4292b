#include "sim/pixel_rays.h"

namespace tripoint {

PixelRays::PixelRays(const CameraModel& camera) : size_(camera.size) {
  rays_.reserve(static_cast<std::size_t>(size_.width_px) * static_cast<std::size_t>(size_.height_px));
  for (int y = 0; y < size_.height_px; ++y) {
    for (int x = 0; x < size_.width_px; ++x) {
      const Result<NormalizedPoint> direction =
          undistorted(camera, {.u_px = static_cast<double>(x), .v_px = static_cast<double>(y)});
      if (!direction) {
        rays_.emplace_back();
        continue;
      }
      rays_.emplace_back(
          PixelRay{.direction = *direction, .per_px = distortion_jacobian_px(camera, *direction).inverse()});
    }
  }
}

}  // namespace tripoint
