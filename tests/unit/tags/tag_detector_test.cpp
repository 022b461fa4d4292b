#include "tags/tag_detector.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <vector>

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

/// Turned any way about the line of sight, tilted by up to 45 degrees, 45 to 105 px wide.
Matrix3 random_view(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Matrix3 turn = Eigen::AngleAxisd(unit(random) * M_PI, Vec3::UnitZ()).toRotationMatrix();
  const double axis_rad = unit(random) * M_PI;
  const Matrix3 tilt = Eigen::AngleAxisd(unit(random) * M_PI / 4.0, Vec3(std::cos(axis_rad), std::sin(axis_rad), 0.0))
                           .toRotationMatrix();
  const double size_mm = 50.0 + 20.0 * unit(random);
  return test::seen_by_camera(tilt * turn, {80.0 * unit(random), 60.0 * unit(random), 420.0}, size_mm);
}

// With noise of 2 luma steps on a step of 170, a crossing errs by about 2 / 170 times the root of the 4 px that it sums
// over, 0.03 px; 25 crossings an edge give 0.01 px at its ends. The figure of the product is 0.02 px.
TEST(TagDetectorTest, CornersAreWhereTheyWereDrawnAndErrAsStated) {
  TagDetector detector = detector_for();
  std::mt19937 random(7);
  constexpr int kViews = 16;
  double squares_px2 = 0.0;
  double normalised = 0.0;
  for (int view = 0; view < kViews; ++view) {
    Sheet sheet({640, 480}, static_cast<std::uint32_t>(view));
    const std::size_t id = static_cast<std::size_t>(view) % kCodes36h11.size();
    const Matrix3 pixels_from_tag = random_view(random);
    sheet.draw(tag36h11(kCodes36h11[id]), pixels_from_tag);
    sheet.add_noise(2.0);
    const std::vector<SeenTag> kept = kept_in(sheet.grey(), detector);
    ASSERT_EQ(kept.size(), 1U) << "view " << view;
    EXPECT_EQ(kept[0].decoded.id, static_cast<int>(id));
    const Errors errors = errors_px(kept[0].outline, pixels_from_tag);
    squares_px2 += errors.squaredNorm() / (2.0 * kTagCorners * kViews);
    normalised += errors.dot(kept[0].outline.covariance_px2.ldlt().solve(errors)) / kViews;
  }
  EXPECT_LT(std::sqrt(squares_px2), 0.02);
  // chi-square of 8 over 16 views: mean 8, deviation 4 / sqrt(16) = 1; the range is four of them.
  EXPECT_GT(normalised, 4.0);
  EXPECT_LT(normalised, 12.0);
}

TEST(TagDetectorTest, TheCentreIsThatOfTheSquareNotTheMeanOfItsPicture) {
  TagDetector detector = detector_for();
  Sheet sheet;
  const Matrix3 tilted = Eigen::AngleAxisd(0.9, Vec3::UnitY()).toRotationMatrix();
  const Matrix3 pixels_from_tag = test::seen_by_camera(tilted, {0.0, 0.0, 300.0}, 60.0);
  sheet.draw(tag36h11(kCodes36h11[0]), pixels_from_tag);
  const std::vector<SeenTag> kept = kept_in(sheet.grey(), detector);
  ASSERT_EQ(kept.size(), 1U);
  const MeasuredPlace centre = centre_of(kept[0].outline);
  EXPECT_NEAR(centre.at.u_px, 320.0, 0.05);  // the mean of the corners lies 1.4 px beside
  EXPECT_NEAR(centre.at.v_px, 240.0, 0.05);
  EXPECT_GT(centre.covariance_px2.determinant(), 0.0);
  EXPECT_LT(centre.covariance_px2.trace(), corner_of(kept[0].outline, 0).covariance_px2.trace());
}

TEST(TagDetectorTest, UpsideDownTheCornersGoWithTheTag) {
  TagDetector detector = detector_for();
  Sheet sheet;
  const Matrix3 turned = Eigen::AngleAxisd(M_PI, Vec3::UnitZ()).toRotationMatrix();
  const Matrix3 pixels_from_tag = test::seen_by_camera(turned, {0.0, 0.0, 400.0}, 50.0);
  sheet.draw(tag36h11(kCodes36h11[1]), pixels_from_tag);
  const std::vector<SeenTag> kept = kept_in(sheet.grey(), detector);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_LT(errors_px(kept[0].outline, pixels_from_tag).cwiseAbs().maxCoeff(), 0.05);
}

TEST(TagDetectorTest, OnlyTheLumaCounts) {
  TagDetector detector = detector_for();
  Sheet sheet;
  sheet.draw(tag36h11(kCodes36h11[0]), upright());
  const Picture grey = sheet.grey();
  std::vector<std::uint8_t> yuyv;
  for (int y = 0; y < grey.size.height_px; ++y) {
    for (int x = 0; x < grey.size.width_px; ++x) {
      yuyv.push_back(grey.luma.at(x, y));
      yuyv.push_back(static_cast<std::uint8_t>(x * 7 + y * 13));
    }
  }
  const Picture packed =
      picture_of({.format = PixelFormat::kYuyv, .size = grey.size, .stride_bytes = 1280, .data = yuyv});
  const std::vector<SeenTag> one = kept_in(grey, detector);
  const std::vector<SeenTag> other = kept_in(packed, detector);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(errors_px(one[0].outline, upright()), errors_px(other[0].outline, upright()));
}

TEST(TagDetectorTest, TheSameTagTwiceIsThereTwice) {
  TagDetector detector = detector_for();
  Sheet sheet;
  for (const double x_mm : {-80.0, 80.0}) {
    sheet.draw(tag36h11(kCodes36h11[2]), test::seen_by_camera(Matrix3::Identity(), {x_mm, 0.0, 400.0}, 50.0));
  }
  const std::vector<SeenTag> kept = kept_in(sheet.grey(), detector);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].decoded.id, 2);
  EXPECT_EQ(kept[1].decoded.id, 2);
}

TEST(TagDetectorTest, AMirroredTagIsNone) {
  TagDetector detector = detector_for();
  for (const std::uint64_t code : kCodes36h11) {
    Sheet sheet;
    sheet.draw(tag36h11(code), upright());
    sheet.mirror();
    EXPECT_TRUE(detector.detect(sheet.grey()).tags.empty());
  }
}

TEST(TagDetectorTest, ATagOfAnotherFamilyIsNone) {
  Sheet sheet;
  sheet.draw(tag36h11(kCodes36h11[0]), upright());
  for (const char* family : {"tag36h10", "tag25h9", "tagStandard41h12", "tagCircle21h7"}) {
    TagDetector detector = detector_for(family);
    EXPECT_TRUE(detector.detect(sheet.grey()).tags.empty()) << family;
  }
}

TEST(TagDetectorTest, HalfATagIsNone) {
  TagDetector detector = detector_for();
  for (const int hidden_px : {20, 40, 60}) {
    Sheet sheet;
    sheet.draw(tag36h11(kCodes36h11[0]), upright());
    sheet.cover(270, 180, 281 + hidden_px, 300);
    EXPECT_TRUE(kept_in(sheet.grey(), detector).empty()) << hidden_px;
  }
}

TEST(TagDetectorTest, ACoveredCornerIsNotGuessed) {
  TagDetector detector = detector_for();
  Sheet sheet;
  sheet.draw(tag36h11(kCodes36h11[0]), upright());
  sheet.cover(350, 190, 380, 214);  // the upper right corner and 10 px to both sides
  for (const SeenTag& tag : kept_in(sheet.grey(), detector)) {
    EXPECT_LT(errors_px(tag.outline, upright()).cwiseAbs().maxCoeff(), 0.1);
  }
}

// A slope that is wider than what is looked at says nothing of where the edge lies, however well its places line up.
TEST(TagDetectorTest, ATagThatMotionBlursIsMeasuredOrRefused) {
  TagDetector detector = detector_for();
  std::mt19937 random(3);
  int measured = 0;
  int refused = 0;
  for (int view = 0; view < 15; ++view) {
    Sheet sheet({640, 480}, static_cast<std::uint32_t>(view));
    const Matrix3 pixels_from_tag = random_view(random);
    sheet.draw(tag36h11(kCodes36h11[0]), pixels_from_tag);
    sheet.smear(1 + 2 * (view % 5));  // odd: nothing moves
    sheet.add_noise(2.0);
    for (const SeenTag& tag : detector.detect(sheet.grey()).tags) {
      if (tag.outline.cause == TagCause::kBlurred) ++refused;
      if (tag.outline.cause != TagCause::kKept) continue;
      ++measured;
      const Errors errors = errors_px(tag.outline, pixels_from_tag);
      EXPECT_LT(errors.cwiseAbs().maxCoeff(), 0.15) << "view " << view;
      EXPECT_LT(errors.dot(tag.outline.covariance_px2.ldlt().solve(errors)), 40.0) << "view " << view;
    }
  }
  EXPECT_GT(measured, 3);
  EXPECT_GT(refused, 3);
}

TEST(TagDetectorTest, TheBitsOfATagWithHardlyAnyContrastAreUnsure) {
  TagDetector detector = detector_for();
  Sheet sheet;
  sheet.draw(tag36h11(kCodes36h11[0]), upright());
  sheet.scale_contrast(0.15);
  const SeenTags seen = detector.detect(sheet.grey());
  ASSERT_EQ(seen.tags.size(), 1U);
  EXPECT_EQ(seen.tags[0].outline.cause, TagCause::kUnsureBits);
  EXPECT_EQ(name(seen.tags[0].outline.cause), "unsure_bits");
}

TEST(TagDetectorTest, APictureTooSmallForATagShowsNone) {
  TagDetector detector = detector_for();
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{31, 31}, ImageSize{640, 4}, ImageSize{32, 32}}) {
    Sheet sheet(size);
    EXPECT_TRUE(detector.detect(sheet.grey()).tags.empty());
  }
}

TEST(TagDetectorTest, AnUnknownFamilyNamesThoseThereAre) {
  const Result<TagDetector> detector = TagDetector::open({.family = "tag36h12"});
  ASSERT_FALSE(detector);
  EXPECT_EQ(detector.error().code, ErrorCode::kOutOfRange);
  EXPECT_NE(detector.error().message.find("tag36h12"), std::string::npos);
  EXPECT_NE(detector.error().message.find("tagStandard41h12"), std::string::npos);
}

// 72 tags of another id in eight rows, and the wanted one among them: more than there is room for, without the others.
TEST(TagDetectorTest, OtherTagsDoNotTakeTheRoomOfThoseThatAreWanted) {
  Sheet sheet({1280, 960});
  for (int i = 0; i < 72; ++i) {
    const Vec3 place_mm((140.0 * (i % 9) + 80.0 - 320.0) / 1.57, (115.0 * (i / 9) + 70.0 - 240.0) / 1.57, 400.0);
    sheet.draw(tag36h11(kCodes36h11[i == 50 ? 2 : 1]), test::seen_by_camera(Matrix3::Identity(), place_mm, 40.0));
  }
  const Picture picture = sheet.grey();
  EXPECT_TRUE(detector_for().detect(picture).cut);
  Result<TagDetector> wanted = TagDetector::open({.ids = {2}});
  ASSERT_TRUE(wanted);
  const SeenTags seen = wanted->detect(picture);
  EXPECT_FALSE(seen.cut);
  ASSERT_EQ(seen.tags.size(), 1U);
  EXPECT_EQ(seen.tags[0].decoded.id, 2);
}

}  // namespace
}  // namespace tripoint
