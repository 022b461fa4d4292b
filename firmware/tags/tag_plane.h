// The plane of a tag in a picture, given by its four corners.
#pragma once

#include <array>

#include "values/forecast.h"
#include "values/linear.h"

namespace tripoint {

/// In the tag's own measure: x right, y down, the square with the corners from -1 to 1.
class TagPlane {
 public:
  /// @param corners_px  of a convex quadrilateral, in the order of DecodedTag
  explicit TagPlane(const std::array<Vec2, kTagCorners>& corners_px);

  struct Place {
    Vec2 at_px;
    Matrix2 px_by_place;  ///< how it moves along x and along y
  };
  [[nodiscard]] Place at(const Vec2& place) const;

 private:
  Matrix3 pixels_from_tag_;
};

}  // namespace tripoint
