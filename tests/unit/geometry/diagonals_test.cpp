#include "geometry/diagonals.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

using Corners = std::array<Vec2, 4>;

/// The unit square seen by a homography that is none of the affine kind.
Vec2 seen(const Vec2& place) {
  Matrix3 homography;
  homography << 80.0, 12.0, 300.0, -9.0, 70.0, 200.0, 0.2, -0.15, 1.0;
  return (homography * place.homogeneous()).hnormalized();
}
Corners seen_square() { return {seen({-1.0, 1.0}), seen({1.0, 1.0}), seen({1.0, -1.0}), seen({-1.0, -1.0})}; }

TEST(DiagonalsTest, TheyMeetInThePictureOfTheCentre) {
  EXPECT_LT((diagonals_of(seen_square()).at - seen({0.0, 0.0})).norm(), 1e-9);
}

TEST(DiagonalsTest, TheCrossingFollowsEachCornerAsItsSlopeSays) {
  const Corners corners = seen_square();
  const DiagonalCrossing crossing = diagonals_of(corners);
  constexpr double kStep = 1e-4;  // of a central difference: error of third order, 1e-10 here
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (int axis = 0; axis < 2; ++axis) {
      Corners ahead = corners;
      Corners behind = corners;
      ahead[k][axis] += kStep;
      behind[k][axis] -= kStep;
      const Vec2 slope = (diagonals_of(ahead).at - diagonals_of(behind).at) / (2.0 * kStep);
      EXPECT_LT((slope - crossing.by_corners.col(static_cast<Eigen::Index>(2 * k) + axis)).norm(), 1e-7) << k << axis;
    }
  }
}

}  // namespace
}  // namespace tripoint
