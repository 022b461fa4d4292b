// Lights that are more than a round spot in the open: hidden, mirrored, elongated, veiled, unequal in the two views.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

/// The bare world seen by two parallel cameras without distortion: straight edges stay straight and upright.
SimulationSettings straight_settings() {
  SimulationSettings settings = bare_settings();
  settings.rig.right_from_left = Isometry3(Eigen::Translation3d(-100.0, 0.0, 0.0));
  for (const Side side : kBothSides) settings.rig.cameras[side].distortion = {};
  return settings;
}

/// A box whose right-hand edge is this far beside the light in the left picture; its middle is at the light's height.
Surface box_beside(const SimulationSettings& settings, double depth_mm, double edge_beside_px) {
  constexpr double kHalf_mm = 80.0;
  const Vec3 left_mm(-50.0, 0.0, 0.0);
  const Vec3 light_mm(0.0, 0.0, 400.0);
  const Vec3 beside_mm(edge_beside_px * depth_mm / settings.rig.cameras.left.focal_px.x() - kHalf_mm, 0.0, 0.0);
  return {.reflectance = {0.0, 0.0, 0.0},
          .outline = Outline{.center_in_reference_mm = left_mm + (light_mm - left_mm) * depth_mm / 400.0 + beside_mm,
                             .half_axes_mm = {kHalf_mm, kHalf_mm},
                             .shape = Shape::kBox}};
}

struct Seen {
  LightTruth truth;
  double energy;
};

Seen seen_left(const SimulationSettings& settings) {
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth truth = renderer.render(kHalfWay, 0).truth.lights[0];
  return {truth, light_moments(renderer).energy};
}

TEST(RendererLightTest, EdgeBeforeALightHidesTheNormalIntegralOfIt) {
  const Seen open = seen_left(straight_settings());
  EXPECT_EQ(open.truth.visible_share, 1.0);
  const double edge_variance_px2 = 0.8 * 0.8 + 1.0 / 12.0;
  for (const double edge_px : {-2.5, -1.0, 0.0, 0.8, 2.0}) {
    SimulationSettings settings = straight_settings();
    settings.scene.surfaces = {box_beside(settings, 300.0, edge_px)};
    const Seen seen = seen_left(settings);
    const double sigma_px = std::sqrt(std::pow(open.truth.core_sigma_px, 2) + edge_variance_px2);
    const double expected = 0.5 * std::erfc(edge_px / (sigma_px * std::numbers::sqrt2));
    EXPECT_NEAR(seen.truth.visible_share, expected, 2e-5) << edge_px;
    // a pixel's mean light times its mean share: its own width is counted twice
    EXPECT_NEAR(seen.energy / open.energy, expected, 5e-3) << edge_px;
  }
}

TEST(RendererLightTest, WhatIsBehindALightHidesNothing) {
  SimulationSettings settings = straight_settings();
  settings.scene.surfaces = {box_beside(settings, 500.0, 20.0)};
  EXPECT_EQ(seen_left(settings).truth.visible_share, 1.0);
}

TEST(RendererLightTest, TiltedPlateHidesWhatIsBehindItsPlaneAndNotWhatSitsBeforeIt) {
  // The plate's centre is at 400 mm; at x = 30 mm its plane lies at 430 mm.
  const double slant = std::numbers::sqrt2 / 2.0;
  SimulationSettings settings = straight_settings();
  settings.scene.surfaces = {{.outline = Outline{.center_in_reference_mm = {0.0, 0.0, 400.0},
                                                 .half_axes_mm = {90.0, 90.0},
                                                 .shape = Shape::kBox,
                                                 .facing = {slant, 0.0, -slant}}}};
  settings.scene.lights[0].mount = Mount::kReference;
  settings.scene.lights[0].place_mm = {30.0, 0.0, 420.0};
  EXPECT_EQ(seen_left(settings).truth.visible_share, 1.0);
  settings.scene.lights[0].place_mm = {30.0, 0.0, 440.0};
  EXPECT_NEAR(seen_left(settings).truth.visible_share, 0.0, 1e-4);
}

TEST(RendererLightTest, HiddenLightLeavesNeitherHaloNorVeil) {
  SimulationSettings settings = straight_settings();
  settings.scene.lights[0].halo_share = 0.05;
  settings.scene.lights[0].veil_share = 0.5;
  settings.scene.surfaces = {box_beside(settings, 300.0, 40.0)};
  const Seen seen = seen_left(settings);
  EXPECT_NEAR(seen.truth.visible_share, 0.0, 1e-5);
  EXPECT_NEAR(seen.energy, 0.0, 1e-2);
}

TEST(RendererLightTest, VeilAddsItsShareOfTheCoresEnergy) {
  SimulationSettings settings = bare_settings();
  const Seen bare = seen_left(settings);
  settings.scene.lights[0].veil_share = 0.4;
  settings.scene.lights[0].veil_of_width = 0.03;  // 19 px: five of them stay inside the picture
  EXPECT_NEAR(seen_left(settings).energy / bare.energy, 1.4, 1e-4);
}

TEST(RendererLightTest, GainIsThatOfTheView) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights[0].gain = {.left = 0.5, .right = 2.0};
  const SimulatedWorld world = world_of(settings);
  const SimulatedWorld even = world_of(bare_settings());
  for (const Side side : kBothSides) {
    FrameRenderer renderer(world, side);
    FrameRenderer even_renderer(even, side);
    const double peak = renderer.render(kHalfWay, 0).truth.lights[0].peak;
    const double even_peak = even_renderer.render(kHalfWay, 0).truth.lights[0].peak;
    const double gain = side == Side::kLeft ? 0.5 : 2.0;
    EXPECT_NEAR(peak / even_peak, gain, 1e-12);
    EXPECT_NEAR(light_moments(renderer).energy / light_moments(even_renderer).energy, gain, 1e-4);
  }
}

TEST(RendererLightTest, ElongatedLightKeepsEnergyAndCentreAndTakesItsAxes) {
  SimulationSettings settings = bare_settings();
  const Seen round = seen_left(settings);
  settings.scene.lights[0].elongation = 1.5;
  settings.scene.lights[0].elongation_angle_rad = std::numbers::pi / 2.0;  // down the picture
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth truth = renderer.render(kHalfWay, 0).truth.lights[0];
  const PictureMoments moments = light_moments(renderer);
  EXPECT_NEAR(moments.energy / round.energy, 1.0, 1e-4);
  EXPECT_NEAR(moments.center.u_px, truth.at.u_px, 1e-3);
  EXPECT_NEAR(moments.center.v_px, truth.at.v_px, 1e-3);
  const double variance_px2 = truth.core_sigma_px * truth.core_sigma_px;
  EXPECT_NEAR(moments.variance_px2.x(), variance_px2 / 1.5 + 1.0 / 12.0, 5e-3);
  EXPECT_NEAR(moments.variance_px2.y(), variance_px2 * 1.5 + 1.0 / 12.0, 5e-3);
}

SimulationSettings mirror_settings(const Outline& mirror) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights[0] = reflection_of(settings.scene.lights[0], mirror, 0.25);
  return settings;
}

TEST(RendererLightTest, MirroredLightIsAsFarBehindTheMirrorAsItIsBefore) {
  const double slant = std::numbers::sqrt2 / 2.0;
  const Outline facing{.center_in_reference_mm = {0.0, 0.0, 500.0}, .half_axes_mm = {60.0, 60.0}};
  const Outline slanted{
      .center_in_reference_mm = {50.0, 0.0, 400.0}, .half_axes_mm = {60.0, 60.0}, .facing = {-slant, 0.0, -slant}};
  const std::array<std::pair<Outline, Vec3>, 2> cases{{{facing, {0.0, 0.0, 600.0}}, {slanted, {50.0, 0.0, 450.0}}}};
  for (const auto& [mirror, image_mm] : cases) {
    const SimulationSettings settings = mirror_settings(mirror);
    const SimulatedWorld world = world_of(settings);
    for (const Side side : kBothSides) {
      const LightTruth truth = render(world, side, kHalfWay).truth.lights[0];
      const RawPixel at = projected(world.rig().cameras[side], world.rig().camera_from_rig[side] * image_mm).value();
      EXPECT_EQ(truth.id, 0);
      EXPECT_NEAR((truth.in_reference_mm - image_mm).norm(), 0.0, 1e-9);
      EXPECT_NEAR(truth.at.u_px, at.u_px, 1e-9);
      EXPECT_NEAR(truth.at.v_px, at.v_px, 1e-9);
      EXPECT_NEAR(truth.visible_share, 1.0, 1e-4);
    }
  }
  EXPECT_EQ(mirror_settings(facing).scene.lights[0].peak, 0.25 * bare_settings().scene.lights[0].peak);
}

TEST(RendererLightTest, MirrorShowsNothingBesideItNorFromBehind) {
  const Outline aside{.center_in_reference_mm = {120.0, 0.0, 500.0}, .half_axes_mm = {60.0, 60.0}};
  EXPECT_NEAR(seen_left(mirror_settings(aside)).truth.visible_share, 0.0, 1e-4);
  const Outline turned{.center_in_reference_mm = {0.0, 0.0, 500.0}, .facing = {0.0, 0.0, 1.0}};
  EXPECT_FALSE(seen_left(mirror_settings(turned)).truth.visible);
  const Outline nearer{.center_in_reference_mm = {0.0, 0.0, 350.0}, .half_axes_mm = {60.0, 60.0}};
  EXPECT_FALSE(seen_left(mirror_settings(nearer)).truth.visible);
}

TEST(RendererLightTest, DirectedLightIsSeenFromBeforeItAloneAndInTheMirrorBehindWhenItTurnsAway) {
  const Outline behind{.center_in_reference_mm = {0.0, 0.0, 500.0}, .half_axes_mm = {60.0, 60.0}};
  const auto seen = [](SimulationSettings settings, const Vec3& facing) {
    settings.scene.lights[0].facing = facing;
    return seen_left(settings).truth.visible;
  };
  EXPECT_TRUE(seen(bare_settings(), {0.0, 0.0, -1.0}));
  EXPECT_FALSE(seen(bare_settings(), {0.0, 0.0, 1.0}));
  EXPECT_FALSE(seen(mirror_settings(behind), {0.0, 0.0, -1.0}));
  EXPECT_TRUE(seen(mirror_settings(behind), {0.0, 0.0, 1.0}));
}

TEST(RendererLightTest, PaintedMirrorDoesNotHideWhatIsSeenInIt) {
  const Outline mirror{.center_in_reference_mm = {0.0, 0.0, 500.0}, .half_axes_mm = {60.0, 60.0}};
  SimulationSettings settings = mirror_settings(mirror);
  settings.scene.surfaces = {{.reflectance = {0.0, 0.0, 0.0}, .outline = mirror}};
  EXPECT_NEAR(seen_left(settings).truth.visible_share, 1.0, 1e-4);
}

TEST(RendererLightTest, ALightGivesWhatTheLitShareOfItsExposureLeaves) {
  SimulationSettings settings = straight_settings();
  settings.exposure = std::chrono::milliseconds(4);
  const double whole = seen_left(settings).energy;
  for (const double share : {0.0, 0.3, 1.0}) {
    settings.lit_share = [share](std::size_t line, Duration, Duration) { return line == 0 ? share : -1.0; };
    const Seen seen = seen_left(settings);
    EXPECT_EQ(seen.truth.lit_share, share);
    EXPECT_NEAR(seen.energy, share * whole, 1e-6 * whole);
  }
}

TEST(RendererLightTest, AMovingLightThatGoesOutIsSeenWhereItWasLit) {
  SimulationSettings settings = straight_settings();
  settings.exposure = std::chrono::milliseconds(20);
  settings.trajectory = straight({0.0, 0.0, 400.0}, {500.0, 0.0, 0.0});  // 10 mm, 15.7 px in an exposure
  settings.lit_share = [](std::size_t, Duration from, Duration) { return from < kHalfWay ? 1.0 : 0.0; };
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const RawPixel middle = renderer.render(kHalfWay, 0).truth.lights[0].at;
  const double path_px = 10.0 / 400.0 * settings.rig.cameras.left.focal_px.x();
  EXPECT_NEAR(light_moments(renderer).center.u_px, middle.u_px - path_px / 4.0, 0.05) << "the first half's middle";
}

TEST(RendererLightTest, WhatNoLineSwitchesIsAlwaysLit) {
  SimulationSettings settings = straight_settings();
  const double whole = seen_left(settings).energy;
  settings.scene.lights[0].switched_by.reset();
  settings.lit_share = [](std::size_t, Duration, Duration) { return 0.0; };
  EXPECT_EQ(seen_left(settings).energy, whole);
}

}  // namespace
}  // namespace tripoint
