// Things that are red, round or both, and are no sphere that can be measured.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/painter.h"
#include "line/detect/sphere_detector.h"
#include "rendered_sphere.h"

namespace tripoint {
namespace {

using bench::Ellipse;
using bench::Painting;
using test::causes;
using test::Pinhole;
using test::Sphere;

const Pinhole kCamera;

/// What is said of the only candidate.
std::string cause_of(const bench::YuyvPicture& picture, const SphereSettings& settings = {}) {
  SphereDetector detector(settings);
  detector.detect(picture.view());
  return causes(detector);
}

TEST(SphereRefusalTest, ASphereThatIsMostlyHiddenIsRefused) {
  const RawPixel at = kCamera.pixel_of(Sphere{}.center_mm);
  Painting painting(kCamera.size, test::kGround);
  add(painting, Sphere{}, kCamera, test::kGround);
  painting.add(Ellipse{
      .at = {at.u_px, at.v_px - 100.0}, .half_width_px = 300.0, .half_height_px = 108.0, .color = {0.01, 0.01, 0.01}});
  SphereDetector detector{SphereSettings{}};
  const auto picture = test::developed(painting);
  EXPECT_TRUE(detector.detect(picture.view()).points.empty());
  EXPECT_EQ(detector.candidates().size(), 1U);
}

// Five bites of 40 degrees out of the rim leave less than half of it, and two thirds of the area.
TEST(SphereRefusalTest, ARimThatIsMostlyHiddenIsRefused) {
  const RawPixel at = kCamera.pixel_of(Sphere{}.center_mm);
  Painting painting(kCamera.size, test::kGround);
  add(painting, Sphere{}, kCamera, test::kGround);
  for (int i = 0; i < 5; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / 5.0;
    painting.add(Ellipse{.at = {at.u_px + 32.0 * std::cos(angle_rad), at.v_px + 32.0 * std::sin(angle_rad)},
                         .half_width_px = 11.0,
                         .half_height_px = 11.0,
                         .color = {0.01, 0.01, 0.01}});
  }
  EXPECT_EQ(cause_of(test::developed(painting)), "hidden_outline ");
}

TEST(SphereRefusalTest, ASphereCutByTheBorderIsRefused) {
  EXPECT_EQ(cause_of(test::picture_of({Sphere{.center_mm = {-115.0, 0.0, 300.0}}})), "cut_by_border ");
}

TEST(SphereRefusalTest, AnotherRadiusIsRefusedOnBothSides) {
  const auto picture = test::picture_of({Sphere{}});  // 32 px
  SphereSettings settings;
  settings.min_radius_px = 35.0;
  EXPECT_EQ(cause_of(picture, settings), "other_radius ");
  settings.min_radius_px = 20.0;
  settings.max_radius_px = 29.0;
  EXPECT_EQ(cause_of(picture, settings), "other_radius ");
}

TEST(SphereRefusalTest, OverlappingSpheresAreRefused) {
  EXPECT_EQ(cause_of(test::picture_of({Sphere{}, Sphere{.center_mm = {14.0, 0.0, 290.0}}})), "sprawling ");
}

/// A red rectangle, pixel by pixel.
Painting rectangle(int half_width_px, int half_height_px) {
  Painting painting(kCamera.size, test::kGround);
  for (int v = 240 - half_height_px; v <= 240 + half_height_px; ++v) {
    for (int u = 320 - half_width_px; u <= 320 + half_width_px; ++u) {
      painting.add(Ellipse{.at = {static_cast<double>(u), static_cast<double>(v)},
                           .half_width_px = 0.4,
                           .half_height_px = 0.4,
                           .color = {0.5, 0.03, 0.03}});
    }
  }
  return painting;
}

TEST(SphereRefusalTest, RectanglesAreRefused) {
  for (const int half_px : {15, 25, 40, 60}) {
    for (const int wider_px : {0, half_px / 2}) {
      SphereDetector detector{SphereSettings{}};
      const auto picture = test::developed(rectangle(half_px + wider_px, half_px));
      EXPECT_TRUE(detector.detect(picture.view()).points.empty()) << half_px << " + " << wider_px;
      EXPECT_EQ(detector.candidates().size(), 1U);
    }
  }
}

TEST(SphereRefusalTest, ARingIsNotFilled) {
  Painting painting(kCamera.size, test::kGround);
  painting.add(
      Ellipse{.at = {320.0, 240.0}, .half_width_px = 40.0, .half_height_px = 40.0, .color = {0.5, 0.03, 0.03}});
  painting.add(Ellipse{.at = {320.0, 240.0}, .half_width_px = 32.0, .half_height_px = 32.0, .color = {0.1, 0.1, 0.1}});
  EXPECT_EQ(cause_of(test::developed(painting)), "not_filled ");
}

TEST(SphereRefusalTest, SpheresOfOtherColoursAreNotCandidates) {
  for (const bench::Color paint : {bench::Color{0.7, 0.25, 0.02}, {0.6, 0.6, 0.6}, {0.05, 0.1, 0.7}}) {
    EXPECT_EQ(cause_of(test::picture_of({Sphere{.paint = paint}})), "");
  }
}

TEST(SphereRefusalTest, PicturesOfNothingGiveNothing) {
  for (const double ground : {0.0, 0.1, 1.0}) EXPECT_EQ(cause_of(test::developed(Painting(kCamera.size, ground))), "");
  std::mt19937 random(5);
  bench::YuyvPicture noise{.size = kCamera.size, .bytes = std::vector<std::uint8_t>(640 * 480 * 2)};
  for (std::uint8_t& byte : noise.bytes) byte = static_cast<std::uint8_t>(random());
  EXPECT_EQ(cause_of(noise), "");
  EXPECT_EQ(cause_of(test::developed(rectangle(319, 239))), "cut_by_border ");
}

TEST(SphereRefusalTest, MoreSpheresThanThereIsRoomForAreSaid) {
  Painting painting(kCamera.size, test::kGround);
  for (int i = 0; i < 130; ++i) {
    painting.add(Ellipse{.at = {30.0 + 40.0 * (i % 15), 30.0 + 40.0 * static_cast<double>(i / 15)},
                         .half_width_px = 14.0,
                         .half_height_px = 14.0,
                         .color = {0.5, 0.03, 0.03}});
  }
  SphereDetector detector{SphereSettings{}};
  const auto picture = test::developed(painting);
  const Detection detection = detector.detect(picture.view());
  EXPECT_TRUE(detection.health.candidates_cut);
  EXPECT_EQ(detector.candidates().size(), kMaxSphereCandidates);
}

}  // namespace
}  // namespace tripoint
