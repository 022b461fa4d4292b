// Tags that a cover, noise or their size could make wrong: measured well enough, or refused.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <random>

#include "drawn_tag.h"
#include "measured_tags.h"

namespace tripoint {
namespace {

using test::detector_for;
using test::Errors;
using test::errors_px;
using test::kCodes36h11;
using test::kept_in;
using test::Sheet;
using test::tag36h11;
using test::upright;

/// A tag in the middle of a picture of its own: turned and tilted any way, of a width between two.
struct RandomTag {
  Matrix3 pixels_from_tag;
  std::size_t id;
};

RandomTag random_tag(std::mt19937& random, double least_px, double most_px) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Matrix3 turn = Eigen::AngleAxisd(unit(random) * M_PI, Vec3::UnitZ()).toRotationMatrix();
  const double axis_rad = unit(random) * M_PI;
  const Matrix3 tilt = Eigen::AngleAxisd(unit(random) * M_PI / 4.0, Vec3(std::cos(axis_rad), std::sin(axis_rad), 0.0))
                           .toRotationMatrix();
  const double width_px = least_px * std::pow(most_px / least_px, 0.5 + 0.5 * unit(random));
  Matrix3 moved = Matrix3::Identity();
  moved.topRightCorner<2, 1>() << 80.0 - 320.0 + 3.0 * unit(random), 80.0 - 240.0 + 3.0 * unit(random);
  return {moved * test::seen_by_camera(tilt * turn, {0.0, 0.0, 400.0}, width_px * 400.0 / 628.0), random() % 3};
}

/// Chi-square of eight with what a pose counts in addition, 0.05 px for the camera. 40 has a chance of 3e-6; the tails
/// of covers and of cells of three pixels are wider than of noise.
double chi_square(const TagOutline& outline, const Matrix3& pixels_from_tag) {
  const Errors errors = errors_px(outline, pixels_from_tag);
  const CornerCovariance stated = outline.covariance_px2 + 0.05 * 0.05 * CornerCovariance::Identity();
  return errors.dot(stated.ldlt().solve(errors));
}

TEST(DoubtfulTagsTest, SmallTagsAndNoiseNeverMakeAWrongOne) {
  TagDetector detector = detector_for();
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int measured = 0;
  for (int view = 0; view < 160; ++view) {
    const RandomTag tag = random_tag(random, 12.0, 60.0);
    Sheet sheet({160, 160}, static_cast<std::uint32_t>(view));
    sheet.draw(tag36h11(kCodes36h11[tag.id]), tag.pixels_from_tag);
    if (view % 2 == 1) sheet.smear(3);
    sheet.add_noise(6.0 * unit(random));
    for (const SeenTag& seen : kept_in(sheet.grey(), detector)) {
      ++measured;
      EXPECT_EQ(seen.decoded.id, static_cast<int>(tag.id));
      EXPECT_LT(chi_square(seen.outline, tag.pixels_from_tag), 40.0) << "view " << view;
      EXPECT_LT(errors_px(seen.outline, tag.pixels_from_tag).cwiseAbs().maxCoeff(), 0.4) << "view " << view;
    }
  }
  EXPECT_GT(measured, 30);
}

// The edge of a cover along an edge of the tag is a straight edge too, and all bits remain right.
TEST(DoubtfulTagsTest, ACoverAlongAnEdgeNeverMovesACorner) {
  TagDetector detector = detector_for();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int measured = 0;
  int refused = 0;
  for (int view = 0; view < 160; ++view) {
    const RandomTag tag = random_tag(random, 35.0, 100.0);
    Sheet sheet({160, 160}, static_cast<std::uint32_t>(view));
    sheet.draw(tag36h11(kCodes36h11[tag.id]), tag.pixels_from_tag);
    const auto corners = test::corners_of(tag.pixels_from_tag);
    const std::size_t edge = random() % kTagCorners;
    const Vec2& from_px = corners[edge];
    const Vec2 way_px = corners[(edge + 1) % kTagCorners] - from_px;
    const double begin_px = -4.0 + 8.0 * unit(random);
    const double end_px = begin_px + (view % 2 == 0 ? 50.0 : 1.0 + 7.0 * unit(random));
    const double begin = view % 3 == 0 ? 0.9 * unit(random) : -0.2;  // along the edge
    sheet.lay_strip(from_px + begin * way_px, from_px + 1.2 * way_px, begin_px, end_px, 255.0 * unit(random));
    sheet.add_noise(2.0 * unit(random));
    for (const SeenTag& seen : detector.detect(sheet.grey()).tags) {
      const TagCause cause = seen.outline.cause;
      if (cause == TagCause::kUnevenLight || cause == TagCause::kShiftedCells) ++refused;
      if (cause != TagCause::kKept) continue;
      ++measured;
      EXPECT_LT(chi_square(seen.outline, tag.pixels_from_tag), 60.0) << "view " << view;
      EXPECT_LT(errors_px(seen.outline, tag.pixels_from_tag).cwiseAbs().maxCoeff(), 0.4) << "view " << view;
    }
  }
  EXPECT_GT(measured, 20);
  EXPECT_GT(refused, 20);
}

// A cover as light as paper, or one as dark as print: nothing but the cells within tells.
TEST(DoubtfulTagsTest, ACoverOfTheLightOfPaperIsToldByTheCells) {
  TagDetector detector = detector_for();
  const auto corners = test::corners_of(upright());
  for (const auto& [begin_px, end_px, luma] : {std::array{-2.0, 12.0, Sheet::kLight}, {-1.0, 2.0, Sheet::kDark}}) {
    Sheet sheet;
    sheet.draw(tag36h11(kCodes36h11[0]), upright());
    sheet.lay_strip(corners[0], corners[1], begin_px, end_px, luma);
    const SeenTags seen = detector.detect(sheet.grey());
    ASSERT_EQ(seen.tags.size(), 1U);
    EXPECT_EQ(name(seen.tags[0].outline.cause), "shifted_cells");
  }
}

TEST(DoubtfulTagsTest, ACoverBesideAnEdgeIsToldByItsLight) {
  TagDetector detector = detector_for();
  const auto corners = test::corners_of(upright());
  const Vec2 way_px = corners[1] - corners[0];
  for (const double share : {1.0, 0.5}) {  // beside all of the edge, beside half of it
    Sheet sheet;
    sheet.draw(tag36h11(kCodes36h11[0]), upright());
    sheet.lay_strip(corners[0] + 0.5 * (1.0 - share) * way_px, corners[1] - 0.5 * (1.0 - share) * way_px, 1.5, 50.0,
                    150.0);
    const SeenTags seen = detector.detect(sheet.grey());
    ASSERT_EQ(seen.tags.size(), 1U);
    EXPECT_EQ(name(seen.tags[0].outline.cause), "uneven_light") << share;
  }
}

}  // namespace
}  // namespace tripoint
