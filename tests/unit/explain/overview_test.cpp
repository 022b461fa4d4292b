#include "explain/overview.h"

#include <gtest/gtest.h>

#include "explain/look.h"

namespace tripoint {
namespace {

constexpr Colour kMiddle{110, 110, 110};

Finding dropped_at(int number, double u_px, double v_px) {
  Finding finding;
  finding.number = number;
  finding.candidate.cause = DropCause::kNotRed;
  finding.candidate.at = {u_px, v_px};
  return finding;
}

Finding kept_at(double u_px, double v_px) {
  Finding finding = dropped_at(1, u_px, v_px);
  finding.candidate.cause = DropCause::kKept;
  finding.covariance_px2 = 0.01 * Matrix2::Identity();
  return finding;
}

Overview overview_with(const std::vector<Finding>& findings, ImageSize size = {640, 480}) {
  return overview_of(plain_image(size, kMiddle), findings, LedDetectorSettings{});
}

TEST(OverviewTest, SmallPicturesGrowAndLargeOnesShrink) {
  EXPECT_DOUBLE_EQ(magnification_of({320, 240}).scale(), 4.0);
  EXPECT_DOUBLE_EQ(magnification_of({640, 480}).scale(), 2.0);
  EXPECT_DOUBLE_EQ(magnification_of({1280, 720}).scale(), 1.0);
  EXPECT_DOUBLE_EQ(magnification_of({1920, 1080}).scale(), 1.0);
  EXPECT_DOUBLE_EQ(magnification_of({3840, 2160}).scale(), 0.5);
  EXPECT_DOUBLE_EQ(magnification_of({4096, 4096}).scale(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(magnification_of({8, 8}).scale(), 8.0);
  EXPECT_DOUBLE_EQ(magnification_of({1, 4096}).scale(), 1.0 / 3.0);
}

// Pixel (100, 50) fills 200 to 201 and 100 to 101 of a picture that is shown twice as large.
TEST(OverviewTest, TheCrossIsWhereTheSpotIs) {
  const RgbImage image = overview_with({kept_at(100.0, 50.0)}).picture.image;
  for (const int x : {199, 200, 201, 202}) EXPECT_GT(image.at(x, 100).green, 150) << x;
  EXPECT_EQ(image.at(150, 100), kMiddle);
}

// 0.1 px in each direction: three of them are drawn as 7.5 px.
TEST(OverviewTest, TheEllipseIsThreeStandardDeviations) {
  const RgbImage image = overview_with({kept_at(100.0, 50.0)}).picture.image;
  int strongest_x = 0;
  for (int x = 206; x < 214; ++x) {  // beyond the arm of the cross
    if (image.at(x, 100).green > image.at(strongest_x, 100).green) strongest_x = x;
  }
  EXPECT_NEAR(strongest_x, 200.5 + 3.0 * 0.1 * kUncertaintyScale, 1.0);
}

TEST(OverviewTest, ADroppedOneHasASquareAndAPlateBesideIt) {
  const RgbImage image = overview_with({dropped_at(3, 100.0, 50.0)}).picture.image;
  EXPECT_GT(image.at(200 - 7, 100).red, 180);
  EXPECT_LT(image.at(200 + 14, 93).red, 60);  // the plate of the label on the right
}

TEST(OverviewTest, ADarkPictureIsShownBrighterAndSaysSo) {
  const Overview dark = overview_of(plain_image({640, 480}, {16, 16, 16}), {}, LedDetectorSettings{});
  EXPECT_TRUE(dark.picture.brightened);
  EXPECT_EQ(dark.picture.image.at(5, 5), (Colour{64, 64, 64}));
  EXPECT_FALSE(overview_with({}).picture.brightened);
}

TEST(OverviewTest, EveryMarkIsLabelledOrCounted) {
  std::vector<Finding> findings;
  for (int i = 0; i < 256; ++i) findings.push_back(dropped_at(i + 1, 2.5 * i, 475.0 - i));
  const Overview overview = overview_with(findings);
  EXPECT_GE(overview.unlabelled, 256 - 60);
  EXPECT_LT(overview.unlabelled, 256);
  EXPECT_EQ(overview_with({dropped_at(1, 320.0, 240.0)}).unlabelled, 0);
}

TEST(OverviewTest, MarksAtTheBordersAreDrawnAndLabelled) {
  const std::vector<Finding> corners{dropped_at(1, 0.0, 0.0), dropped_at(2, 639.0, 0.0), dropped_at(3, 0.0, 479.0),
                                     dropped_at(4, 639.0, 479.0)};
  const Overview overview = overview_with(corners);
  EXPECT_EQ(overview.unlabelled, 0);
  EXPECT_EQ(overview.picture.image.size, (ImageSize{1280, 960}));
  EXPECT_GT(overview.picture.image.at(1279 - 7, 955).red, 180);
}

}  // namespace
}  // namespace tripoint
