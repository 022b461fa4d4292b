// How strong the light at a place of a picture is, whether it is a spot or not.
#pragma once

#include <optional>

#include "line/detect/spot_window.h"
#include "ports/frame.h"
#include "values/pixel.h"

namespace tripoint {

class PlaceLight {
 public:
  /// Largest strength S within a radius of the place, above the median of a ring around.
  ///
  /// @param radius_px  up to kMaxRadius_px
  /// @return nothing when the ring is not all in the picture
  std::optional<int> contrast(const Picture& picture, const RawPixel& place, double radius_px);

  static constexpr double kMaxRadius_px = 30.0;

 private:
  SpotWindow window_;
};

}  // namespace tripoint
