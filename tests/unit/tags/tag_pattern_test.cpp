#include "tags/tag_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_tag.h"
#include "tags/tag_plane.h"
#include "tags/tag_print.h"

namespace tripoint {
namespace {

TagPattern pattern_of(std::string_view family, int id) { return tripoint::pattern_of(*tag_print(family, id)); }

TEST(TagPatternTest, TheBitsAreThePublishedOnesAtTheirPlaces) {
  for (std::size_t id = 0; id < test::kCodes36h11.size(); ++id) {
    const TagPattern pattern = pattern_of("tag36h11", static_cast<int>(id));
    ASSERT_EQ(pattern.bits.size(), 36U);
    EXPECT_EQ(pattern.cells_across, 8);
    EXPECT_FALSE(pattern.light_inside);
    const test::TagCells published = test::tag36h11(test::kCodes36h11[id]);
    for (const CellMiddle& bit : pattern.bits) {
      const auto column = static_cast<std::size_t>((bit.at.x() + 1.0) / pattern.cell() + 1.0);
      const auto row = static_cast<std::size_t>((bit.at.y() + 1.0) / pattern.cell() + 1.0);
      EXPECT_EQ(bit.light, published.light[row][column]);
    }
  }
}

TEST(TagPatternTest, SidesLieBetweenALightAndADarkCellButNotOnTheEdges) {
  const TagPattern pattern = pattern_of("tag36h11", 0);
  const test::TagCells published = test::tag36h11(test::kCodes36h11[0]);
  EXPECT_GT(pattern.sides.size(), 30U);
  for (const CellSide& side : pattern.sides) {
    EXPECT_LT(side.at.cwiseAbs().maxCoeff(), 1.0);
    const Vec2 half = 0.5 * pattern.cell() * (side.between_x ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0));
    const auto light_at = [&](const Vec2& place) {
      const auto column = static_cast<std::size_t>((place.x() + 1.0) / pattern.cell() + 1.0);
      const auto row = static_cast<std::size_t>((place.y() + 1.0) / pattern.cell() + 1.0);
      return published.light[row][column];
    };
    EXPECT_EQ(light_at(side.at + half), side.light_after);
    EXPECT_NE(light_at(side.at - half), side.light_after);
  }
}

TEST(TagPatternTest, FamiliesWithBitsAroundTheSquareShowThemToo) {
  const TagPattern pattern = pattern_of("tagStandard41h12", 3);
  EXPECT_EQ(pattern.bits.size(), 41U);
  EXPECT_TRUE(pattern.light_inside);
  EXPECT_TRUE(std::any_of(pattern.bits.begin(), pattern.bits.end(),
                          [](const CellMiddle& bit) { return bit.at.cwiseAbs().maxCoeff() > 1.0; }));
}

TEST(TagPlaneTest, PlacesAndTheirMotionAreThoseOfThePerspective) {
  const Matrix3 tilted = Eigen::AngleAxisd(0.7, Vec3(0.6, 0.8, 0.0)).toRotationMatrix();
  const Matrix3 pixels_from_tag = test::seen_by_camera(tilted, {30.0, -20.0, 300.0}, 60.0);
  const TagPlane plane(test::corners_of(pixels_from_tag));
  const auto truth = [&](const Vec2& place) -> Vec2 { return (pixels_from_tag * place.homogeneous()).hnormalized(); };
  for (const Vec2& place : {Vec2(0.0, 0.0), Vec2(-1.0, 1.0), Vec2(0.3, -0.8), Vec2(1.4, 1.2)}) {
    EXPECT_LT((plane.at(place).at_px - truth(place)).norm(), 1e-9);
    constexpr double kStep = 1e-6;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const Vec2 step = kStep * Vec2::Unit(axis);
      const Vec2 slope = (truth(place + step) - truth(place - step)) / (2.0 * kStep);
      EXPECT_LT((plane.at(place).px_by_place.col(axis) - slope).norm(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace tripoint
