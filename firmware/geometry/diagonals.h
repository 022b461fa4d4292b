// Where the diagonals of a quadrilateral meet.
#pragma once

#include <array>

#include "values/linear.h"

namespace tripoint {

struct DiagonalCrossing {
  Vec2 at = Vec2::Zero();
  /// How it follows the corners: over x and y of corner 0, of corner 1 and so on.
  Eigen::Matrix<double, 2, 8> by_corners = Eigen::Matrix<double, 2, 8>::Zero();
};

/// Of the picture of a square it is the picture of its centre, however the square is tilted: a perspective keeps lines
/// straight. The mean of the corners is not.
///
/// @param corners  of a convex quadrilateral, in order around it
DiagonalCrossing diagonals_of(const std::array<Vec2, 4>& corners);

}  // namespace tripoint
