#include "line/detect/sphere_detector.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/painter.h"
#include "rendered_sphere.h"

namespace tripoint {
namespace {

using bench::Ellipse;
using bench::Painting;
using test::causes;
using test::Pinhole;
using test::Sphere;

constexpr double kDegree_rad = std::numbers::pi / 180.0;
const Pinhole kCamera;

/// The centre of the ellipse that is its outline: see SphereDetector.
RawPixel outline_center(const Sphere& sphere) {
  const RawPixel projected = kCamera.pixel_of(sphere.center_mm);
  const RawPixel middle = kCamera.pixel_of({0.0, 0.0, 1.0});
  const double stretch = 1.0 + std::pow(short_half_axis_px(sphere, kCamera) / kCamera.focal_px, 2);
  return {middle.u_px + stretch * (projected.u_px - middle.u_px),
          middle.v_px + stretch * (projected.v_px - middle.v_px)};
}

double distance_px(const RawPixel& a, const RawPixel& b) { return std::hypot(a.u_px - b.u_px, a.v_px - b.v_px); }

double deviations(const ImagePoint& point, const RawPixel& truth) {
  const Vec2 error(point.at.u_px - truth.u_px, point.at.v_px - truth.v_px);
  return std::sqrt(error.dot(point.covariance_px2.llt().solve(error)));
}

/// Lit at this angle from the line of sight, from a side that turns with it.
Vec3 light_at(double phase_deg, double around_deg) {
  const double sine = std::sin(phase_deg * kDegree_rad);
  return {sine * std::cos(around_deg * kDegree_rad), sine * std::sin(around_deg * kDegree_rad),
          -std::cos(phase_deg * kDegree_rad)};
}

/// Somewhere in the picture with a margin of 4 px, lit at up to 60 degrees from the line of sight.
Sphere random_sphere(const Pinhole& camera, double radius_px, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double depth_mm = camera.focal_px * 12.0 / radius_px;
  const double stretched_px = 1.4 * radius_px + 4.0;  // its picture's long axis in the corner of the wider lens
  const auto aside_mm = [&](int size_px) {
    return depth_mm / camera.focal_px * (0.5 * size_px - stretched_px) * (2.0 * share(random) - 1.0);
  };
  return {.center_mm = {aside_mm(camera.size.width_px), aside_mm(camera.size.height_px), depth_mm},
          .to_light = light_at(60.0 * share(random), 360.0 * share(random)),
          .ambient = 0.1 + 0.2 * share(random)};
}

/// So many of a hundred are found, and those within what is stated.
void expect_found_through(const Pinhole& camera, int least) {
  SphereDetector detector{SphereSettings{}};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius_px(12.0, 80.0);
  int found = 0;
  int inside = 0;
  constexpr int kScenes = 100;
  for (std::uint32_t seed = 1; seed <= kScenes; ++seed) {
    const Sphere sphere = random_sphere(camera, radius_px(random), random);
    const auto picture = test::picture_of({sphere}, camera, seed);
    const Detection detection = detector.detect(picture.view());
    ASSERT_LE(detection.points.size(), 1U) << "seed " << seed;
    if (detection.points.empty()) continue;
    ++found;
    const double away = deviations(detection.points[0], camera.pixel_of(sphere.center_mm));
    EXPECT_LT(away, 4.3) << "seed " << seed;  // a normal error in two axes: one in ten thousand
    inside += away < 3.0 ? 1 : 0;
  }
  EXPECT_GE(found, least);
  EXPECT_GE(inside, found * 97 / 100);  // 98.9 % expected
}

TEST(SphereDetectorTest, FindsEveryLitSphereWithinWhatIsStated) {
  expect_found_through(Pinhole{.focal_px = 1000.0}, 100);
}

// The widest lens that the covariance knows of. In its corners ellipses are too long for circles, and are refused.
TEST(SphereDetectorTest, ThroughAWideLensErrorsAreWithinWhatIsStated) {
  expect_found_through(Pinhole{.focal_px = 512.0}, 75);
}

// Part of a long ellipse: what a holder leaves of the outline has another circle than the whole.
TEST(SphereDetectorTest, PartOfAnOutlineInACornerErrsWithinWhatIsStated) {
  const Pinhole wide{.focal_px = 512.0};
  const Sphere sphere{.center_mm = {106.5, 41.0, 204.8}, .to_light = {0.0, 0.0, -1.0}, .highlight = 0.0};
  const RawPixel at = wide.pixel_of(sphere.center_mm);
  const double radius_px = short_half_axis_px(sphere, wide);
  int found = 0;
  for (int direction = 0; direction < 16; ++direction) {
    const double around_rad = 0.4 * direction;
    Painting painting(wide.size, test::kGround);
    add(painting, sphere, wide, test::kGround);
    painting.add(Ellipse{
        .at = {at.u_px + 1.3 * radius_px * std::cos(around_rad), at.v_px + 1.3 * radius_px * std::sin(around_rad)},
        .half_width_px = radius_px,
        .half_height_px = radius_px,
        .color = {0.01, 0.01, 0.01}});
    const auto picture = test::developed(painting);
    SphereDetector detector{SphereSettings{}};
    const Detection detection = detector.detect(picture.view());
    if (detection.points.empty()) continue;
    ++found;
    EXPECT_LT(deviations(detection.points[0], at), 2.0) << around_rad;  // it is the lens, not noise
  }
  EXPECT_GE(found, 8);
}

TEST(SphereDetectorTest, LitFromTheFrontItIsFoundToPartOfAPixel) {
  const Sphere sphere{.to_light = {-0.1, -0.2, -1.0}};
  const auto picture = test::picture_of({sphere});
  SphereDetector detector{SphereSettings{}};
  const Detection detection = detector.detect(picture.view());
  ASSERT_EQ(detection.points.size(), 1U) << causes(detector);
  EXPECT_LT(distance_px(detection.points[0].at, kCamera.pixel_of(sphere.center_mm)), 0.4);
  EXPECT_NEAR(detection.points[0].sigma_px, short_half_axis_px(sphere, kCamera), 1.0);
}

TEST(SphereDetectorTest, LightFromTheSideLeavesEnoughToFindIt) {
  for (const double phase_deg : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0}) {
    for (double around_deg = 0.0; around_deg < 360.0; around_deg += 45.0) {
      const Sphere sphere{.to_light = light_at(phase_deg, around_deg), .ambient = 0.0};
      SphereDetector detector{SphereSettings{}};
      const auto picture = test::picture_of({sphere});
      const Detection detection = detector.detect(picture.view());
      ASSERT_EQ(detection.points.size(), 1U) << phase_deg << ", " << around_deg << ": " << causes(detector);
      EXPECT_LT(distance_px(detection.points[0].at, outline_center(sphere)), 2.5) << phase_deg << ", " << around_deg;
      EXPECT_LT(deviations(detection.points[0], outline_center(sphere)), 3.0) << phase_deg << ", " << around_deg;
    }
  }
}

TEST(SphereDetectorTest, LightFromBehindLeavesTooLittle) {
  for (const double phase_deg : {110.0, 130.0, 150.0}) {
    const Sphere sphere{.to_light = light_at(phase_deg, 30.0), .ambient = 0.0};
    SphereDetector detector{SphereSettings{}};
    const auto picture = test::picture_of({sphere});
    EXPECT_TRUE(detector.detect(picture.view()).points.empty()) << phase_deg;
  }
}

// The ends of the ellipse along its long axis, f tan(t +- s), by themselves: its middle against the formula.
TEST(SphereDetectorTest, TheCentreOfTheOutlineLiesBeyondThePictureOfTheCentre) {
  for (const double aside_mm : {20.0, 60.0, 100.0}) {
    const Sphere sphere{.center_mm = {aside_mm, 0.0, 150.0}, .radius_mm = 20.0};
    const double from_axis_rad = std::atan2(aside_mm, 150.0);
    const double angular_radius_rad = std::asin(20.0 / sphere.center_mm.norm());
    const double middle_px =
        0.5 * kCamera.focal_px *
        (std::tan(from_axis_rad + angular_radius_rad) + std::tan(from_axis_rad - angular_radius_rad));
    EXPECT_NEAR(outline_center(sphere).u_px - kCamera.pixel_of({0.0, 0.0, 1.0}).u_px, middle_px, 1e-9);
  }
}

TEST(SphereDetectorTest, TheCovarianceStatesHowFarTheOutlineLiesBeyondTheCentre) {
  // 90 px of radius, 178 px beside the axis: 2.2 px; for a lens of 512 px the covariance states 5.5 px.
  const Sphere sphere{.center_mm = {40.0, 0.0, 180.0}, .radius_mm = 20.0, .to_light = {0.0, 0.0, -1.0}};
  const auto picture = test::picture_of({sphere});
  SphereDetector detector{SphereSettings{}};
  const Detection detection = detector.detect(picture.view());
  ASSERT_EQ(detection.points.size(), 1U) << causes(detector);
  const ImagePoint& point = detection.points[0];
  EXPECT_LT(distance_px(point.at, outline_center(sphere)), 1.0);
  const double beyond_px = distance_px(outline_center(sphere), kCamera.pixel_of(sphere.center_mm));
  EXPECT_GT(beyond_px, 2.0);
  EXPECT_GT(std::sqrt(point.covariance_px2(0, 0)), beyond_px);
  EXPECT_LT(std::sqrt(point.covariance_px2(1, 1)), 0.5 * beyond_px + 0.5);  // towards the middle, not across
}

TEST(SphereDetectorTest, PlanesGiveTheSamePointAsYuyv) {
  const auto picture = test::picture_of({Sphere{}});
  SphereDetector detector{SphereSettings{}};
  const Detection interleaved = detector.detect(picture.view());
  ASSERT_EQ(interleaved.points.size(), 1U);
  for (const bool halved : {false, true}) {
    const auto planes = bench::planes_of(picture, halved);
    const Detection planar = detector.detect(planes.view());
    ASSERT_EQ(planar.points.size(), 1U);
    EXPECT_LT(distance_px(planar.points[0].at, interleaved.points[0].at), halved ? 0.5 : 1e-9);
  }
}

TEST(SphereDetectorTest, AHolderInFrontTakesUpToAThird) {
  const Sphere sphere{.to_light = {0.0, -0.3, -1.0}};
  const RawPixel at = kCamera.pixel_of(sphere.center_mm);
  Painting painting(kCamera.size, test::kGround);
  add(painting, sphere, kCamera, test::kGround);
  painting.add(Ellipse{
      .at = {at.u_px, at.v_px - 30.0}, .half_width_px = 14.0, .half_height_px = 30.0, .color = {0.01, 0.01, 0.01}});
  const auto picture = test::developed(painting);
  SphereDetector detector{SphereSettings{}};
  const Detection detection = detector.detect(picture.view());
  ASSERT_EQ(detection.points.size(), 1U) << causes(detector);
  EXPECT_LT(deviations(detection.points[0], at), 3.0);
}

}  // namespace
}  // namespace tripoint
