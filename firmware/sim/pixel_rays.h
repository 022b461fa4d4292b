// The viewing direction of every pixel of a camera, found once.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/camera_model.h"
#include "values/linear.h"

namespace tripoint {

/// A viewing direction, and how it changes from pixel to pixel.
struct PixelRay {
  NormalizedPoint direction;
  Matrix2 per_px = Matrix2::Identity();  ///< d(direction) / d(u, v)
};

class PixelRays {
 public:
  explicit PixelRays(const CameraModel& camera);

  /// Nothing where the lens cannot be inverted.
  [[nodiscard]] const std::optional<PixelRay>& at(int x, int y) const {
    return rays_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width_px) + static_cast<std::size_t>(x)];
  }

 private:
  ImageSize size_;
  std::vector<std::optional<PixelRay>> rays_;
};

}  // namespace tripoint
