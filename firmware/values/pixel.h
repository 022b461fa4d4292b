// Places in a picture. Two types, because distortion must never be forgotten or applied twice.
#pragma once

#include <cstdint>

namespace tripoint {

/// A place in the picture as the camera delivers it: distortion still present, pixel centres at integers.
struct RawPixel {
  double u_px = 0.0;
  double v_px = 0.0;
};

/// A viewing direction without distortion, on the plane z = 1 of the camera frame (x right, y down, z forward).
struct NormalizedPoint {
  double x = 0.0;
  double y = 0.0;
};

struct ImageSize {
  int width_px = 0;
  int height_px = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

}  // namespace tripoint
