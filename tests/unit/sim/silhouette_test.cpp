#include "sim/silhouette.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr double kFocal_px = 600.0;
constexpr double kBlur_px = 0.8;
const CameraModel kCamera{
    .size = {.width_px = 320, .height_px = 240}, .focal_px = {kFocal_px, kFocal_px}, .center_px = {160.0, 120.0}};

Silhouette seen(const Outline& outline) {
  return silhouette_of(outline, kCamera, Isometry3::Identity(), kBlur_px).value();
}

double area_px2(const Silhouette& silhouette) {
  const NormalIntegral normal;
  double area = 0.0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) area += covered_share(silhouette, x, y, normal);
  }
  return area;
}

TEST(SilhouetteTest, BoxCoversItsSides) {
  const Outline box{.center_in_reference_mm = {3.0, -7.0, 500.0},
                    .half_axes_mm = {40.0, 12.0},
                    .shape = Shape::kBox,
                    .angle_rad = 0.6};
  const double px_per_mm = kFocal_px / 500.0;
  const double expected = 4.0 * 40.0 * 12.0 * px_per_mm * px_per_mm;
  EXPECT_NEAR(area_px2(seen(box)), expected, 1e-4 * expected);  // blur moves light, it makes none
}

TEST(SilhouetteTest, CableThinnerThanAPixelCoversItsWidth) {
  const Outline cable{.center_in_reference_mm = {0.0, 0.0, 500.0}, .half_axes_mm = {60.0, 0.2}, .shape = Shape::kBox};
  const double px_per_mm = kFocal_px / 500.0;
  const double expected = 4.0 * 60.0 * 0.2 * px_per_mm * px_per_mm;
  EXPECT_NEAR(area_px2(seen(cable)), expected, 1e-3 * expected);
}

TEST(SilhouetteTest, EllipseCoversItsAreaAndTheBlurOfItsRim) {
  const Outline ellipse{.center_in_reference_mm = {-2.0, 5.0, 500.0}, .half_axes_mm = {45.0, 25.0}, .angle_rad = -0.4};
  const double px_per_mm = kFocal_px / 500.0;
  // A convex rim softened by sigma gains pi sigma^2 (Steiner's formula, averaged over a normal offset).
  const double blur = std::numbers::pi * (kBlur_px * kBlur_px + 1.0 / 12.0);
  const double expected = std::numbers::pi * 45.0 * 25.0 * px_per_mm * px_per_mm + blur;
  EXPECT_NEAR(area_px2(seen(ellipse)), expected, 5e-4 * expected);  // the distance to the rim is of first order
}

TEST(SilhouetteTest, EdgeIsTheNormalIntegral) {
  const Silhouette box =
      seen({.center_in_reference_mm = {0.0, 0.0, 300.0}, .half_axes_mm = {20.0, 20.0}, .shape = Shape::kBox});
  const NormalIntegral normal;
  const double edge_px = 160.0 + 20.0 * kFocal_px / 300.0;
  const double sigma_px = std::sqrt(kBlur_px * kBlur_px + 1.0 / 12.0);
  for (const double inside_px : {-2.0, -0.5, 0.0, 0.7, 1.9}) {
    const double expected = 0.5 * std::erfc(-inside_px / (sigma_px * std::numbers::sqrt2));
    EXPECT_NEAR(covered_share(box, edge_px - inside_px, 120.0, normal), expected, 2e-6) << inside_px;
  }
}

TEST(SilhouetteTest, TiltedFigureIsForeshortened) {
  const double tilt_rad = std::numbers::pi / 3.0;
  const Outline tilted{.center_in_reference_mm = {0.0, 0.0, 500.0},
                       .half_axes_mm = {40.0, 40.0},
                       .shape = Shape::kBox,
                       .facing = {std::sin(tilt_rad), 0.0, -std::cos(tilt_rad)}};
  const double px_per_mm = kFocal_px / 500.0;
  const double expected = 4.0 * 40.0 * 40.0 * px_per_mm * px_per_mm * 0.5;  // cos 60 degrees
  EXPECT_NEAR(area_px2(seen(tilted)), expected, 1e-4 * expected);
}

TEST(SilhouetteTest, FigureBehindTheCameraOrEdgeOnIsNotSeen) {
  EXPECT_FALSE(silhouette_of({.center_in_reference_mm = {0.0, 0.0, -500.0}}, kCamera, Isometry3::Identity(), 0.8));
  EXPECT_FALSE(silhouette_of({.center_in_reference_mm = {0.0, 0.0, 500.0}, .facing = {1.0, 0.0, 0.0}}, kCamera,
                             Isometry3::Identity(), 0.8));
}

TEST(SilhouetteTest, MaskHidesWhatItCoversAndAMirrorTheRest) {
  const NormalIntegral normal;
  const Silhouette disc = seen({.center_in_reference_mm = {0.0, 0.0, 300.0}, .half_axes_mm = {10.0, 10.0}});
  const Mask hides{.silhouette = disc};
  const Mask shows{.silhouette = disc, .shows_inside = true};
  EXPECT_NEAR(passed_share({&hides, 1}, 160.0, 120.0, normal), 0.0, 1e-6);
  EXPECT_EQ(passed_share({&hides, 1}, 260.0, 120.0, normal), 1.0);
  EXPECT_NEAR(passed_share({&shows, 1}, 160.0, 120.0, normal), 1.0, 1e-6);
  EXPECT_EQ(passed_share({&shows, 1}, 260.0, 120.0, normal), 0.0);
}

}  // namespace
}  // namespace tripoint
