#include "sim/painting.h"

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

/// A white figure, evenly lit, in a dark room.
SimulationSettings settings_with(const std::vector<Surface>& surfaces) {
  SimulationSettings settings = bare_settings();
  settings.scene.white_level = 1.0;
  settings.scene.surfaces = surfaces;
  return settings;
}

Surface plain(const Outline& outline, const LinearColor& reflectance = {1.0, 1.0, 1.0}) {
  return {.reflectance = reflectance, .texture = 0.0, .outline = outline};
}

double level_at(const SimulatedWorld& world, const RawPixel& at) {
  const auto x = static_cast<std::size_t>(std::lround(at.u_px));
  const auto y = static_cast<std::size_t>(std::lround(at.v_px));
  return static_cast<double>(world.background(Side::kLeft)[y * 640 + x]);
}

TEST(PaintingTest, CenterOfAFigureIsWhereBothCamerasProjectIt) {
  const Vec3 place_mm(35.0, -22.0, 520.0);
  const SimulatedWorld world =
      world_of(settings_with({plain({.center_in_reference_mm = place_mm, .half_axes_mm = {14.0, 9.0}})}));
  for (const Side side : kBothSides) {
    const std::vector<float>& levels = world.background(side);
    const PictureMoments moments = moments_of(
        [&](int x, int y) { return static_cast<double>(levels[static_cast<std::size_t>(y * 640 + x)]); }, {});
    const RawPixel truth = projected(world.rig().cameras[side], world.rig().camera_from_rig[side] * place_mm).value();
    // Sampled at whole pixels: a rim softened by 0.85 px leaves less than 1e-3 px.
    EXPECT_NEAR(moments.center.u_px, truth.u_px, 1e-3);
    EXPECT_NEAR(moments.center.v_px, truth.v_px, 1e-3);
  }
}

TEST(PaintingTest, NearFigureIsBeforeTheFarOneWhateverTheirOrder) {
  const Surface near = plain({.center_in_reference_mm = {0.0, 0.0, 400.0}}, {0.2, 0.2, 0.2});
  const Surface far = plain({.center_in_reference_mm = {0.0, 0.0, 600.0}, .half_axes_mm = {60.0, 60.0}});
  for (const std::vector<Surface>& surfaces : {std::vector{near, far}, std::vector{far, near}}) {
    const SimulatedWorld world = world_of(settings_with(surfaces));
    EXPECT_NEAR(level_at(world, world.figures(Side::kLeft).back().silhouette.center), 0.2, 1e-6);
  }
}

TEST(PaintingTest, FigureIsBeforeTheWallAndHasTheMosaicOfItsColour) {
  const Surface wall{.reflectance = {0.1, 0.1, 0.1}, .texture = 0.0};
  const Surface red = plain({.center_in_reference_mm = {0.0, 0.0, 400.0}}, {0.8, 0.4, 0.2});
  const SimulatedWorld world = world_of(settings_with({red, wall}));
  const RawPixel center = world.figures(Side::kLeft)[0].silhouette.center;
  const double u_px = 2.0 * std::floor(center.u_px / 2.0);
  const double v_px = 2.0 * std::floor(center.v_px / 2.0);
  EXPECT_NEAR(level_at(world, {u_px, v_px}), 0.8, 1e-6);
  EXPECT_NEAR(level_at(world, {u_px + 1.0, v_px}), 0.4, 1e-6);
  EXPECT_NEAR(level_at(world, {u_px, v_px + 1.0}), 0.4, 1e-6);
  EXPECT_NEAR(level_at(world, {u_px + 1.0, v_px + 1.0}), 0.2, 1e-6);
  EXPECT_NEAR(level_at(world, {2.0, 2.0}), 0.1, 1e-6);
}

TEST(PaintingTest, ShadingDarkensTowardsTheRim) {
  Surface ball = plain({.center_in_reference_mm = {0.0, 0.0, 400.0}, .half_axes_mm = {40.0, 40.0}});
  ball.shading = 0.5;
  const SimulatedWorld world = world_of(settings_with({ball}));
  const Silhouette& seen = world.figures(Side::kLeft)[0].silhouette;
  for (const double offset_px : {0.0, 20.0, 40.0}) {
    const RawPixel at{std::round(seen.center.u_px + offset_px), std::round(seen.center.v_px)};
    const double expected = 1.0 - 0.5 * place_on(seen, at.u_px, at.v_px).squaredNorm();
    EXPECT_NEAR(level_at(world, at), expected, 1e-6) << offset_px;
  }
}

TEST(PaintingTest, HotPixelsAreExactlyTheSeededOnesAndNoneByDefault) {
  SimulationSettings settings = settings_with({});
  settings.sensor.hot_pixel_share = 1e-4;
  settings.sensor.hot_pixel_level = 0.3;
  const SimulatedWorld world = world_of(settings);
  const SimulatedWorld again = world_of(settings);
  for (const Side side : kBothSides) {
    const std::vector<float>& levels = world.background(side);
    EXPECT_EQ(world.hot_pixels(side).size(), 31U);  // of 307,200, none drawn twice with this seed
    EXPECT_EQ(std::ranges::count(levels, 0.0F), 307'200 - 31);
    for (const std::size_t pixel : world.hot_pixels(side)) EXPECT_EQ(levels[pixel], 0.3F);
    EXPECT_EQ(levels, again.background(side));
  }
  EXPECT_NE(world.background(Side::kLeft), world.background(Side::kRight));
  settings.sensor.hot_pixel_share = 0.0;
  EXPECT_EQ(std::ranges::max(world_of(settings).background(Side::kLeft)), 0.0F);
}

}  // namespace
}  // namespace tripoint
