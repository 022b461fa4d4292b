#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/renderer.h"
#include "still_world.h"

namespace tripoint {
namespace {

/// A camera without distortion, looking straight ahead: velocities in the picture have a closed form.
StereoCalibration plain_rig() {
  StereoCalibration calibration;
  for (const Side side : kBothSides) {
    calibration.cameras[side] = {.size = {.width_px = 640, .height_px = 480},
                                 .focal_px = {600.0, 600.0},
                                 .center_px = {319.5, 239.5},
                                 .distortion = {}};
  }
  calibration.right_from_left.translation() = Vec3(-100.0, 0.0, 0.0);
  return calibration;
}

SimulationSettings moving_settings(const Vec3& velocity_mm_per_s) {
  SimulationSettings settings = bare_settings();
  settings.rig = plain_rig();
  settings.trajectory = straight({0.0, 0.0, 400.0}, velocity_mm_per_s);
  return settings;
}

TEST(RendererMotionTest, BlurAddsTheVarianceOfItsLength) {
  SimulationSettings settings = moving_settings({400.0, 0.0, 0.0});
  const SimulatedWorld still = world_of(settings);
  settings.exposure = std::chrono::milliseconds{10};
  const SimulatedWorld blurred = world_of(settings);
  FrameRenderer sharp_renderer(still, Side::kLeft);
  FrameRenderer blurred_renderer(blurred, Side::kLeft);
  const LightTruth light = sharp_renderer.render(kHalfWay, 0).truth.lights[0];
  blurred_renderer.render(kHalfWay, 0);
  const PictureMoments sharp = light_moments(sharp_renderer);
  const PictureMoments smeared = light_moments(blurred_renderer);
  const double length_px = 400.0 * 600.0 / 400.0 * 0.010;  // 6 px
  // Instants every sixth of a sigma are short of the integral by (sigma/6)^2/12; the rest is the cut at five sigma.
  const double tolerance_px2 = light.core_sigma_px * light.core_sigma_px / 432.0 + 0.005;
  EXPECT_NEAR(smeared.variance_px2.x() - sharp.variance_px2.x(), length_px * length_px / 12.0, tolerance_px2);
  EXPECT_NEAR(smeared.variance_px2.y(), sharp.variance_px2.y(), 1e-3);
  EXPECT_NEAR(smeared.energy, sharp.energy, 1e-4 * sharp.energy);
  EXPECT_NEAR(smeared.center.u_px, light.at.u_px, 1e-3);
}

TEST(RendererMotionTest, BlurredSpotIsFlatOverItsPath) {
  SimulationSettings settings = moving_settings({4000.0, 0.0, 0.0});
  settings.exposure = std::chrono::milliseconds{10};
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth light = renderer.render(kHalfWay, 0).truth.lights[0];
  const auto column = [&](int x) {
    double sum = 0.0;
    for (int y = 0; y < 480; ++y) sum += static_cast<double>(renderer.light().row(y)[static_cast<std::size_t>(x)]);
    return sum;
  };
  const double energy = light_moments(renderer).energy;
  for (const int x : {380, 388, 394, 401, 409}) EXPECT_NEAR(column(x), energy / 60.0, 2e-3 * energy / 60.0) << x;
  // at both ends of the 60 px path half of it
  EXPECT_NEAR(column(364) + column(365), energy / 60.0, 0.02 * energy / 60.0);
  EXPECT_NEAR(light.at.u_px, 319.5 + 600.0 * 50.0 / 400.0, 1e-9);
}

TEST(RendererMotionTest, RollingShutterSeesEachRowAtItsOwnTime) {
  SimulationSettings settings = moving_settings({300.0, 0.0, 0.0});
  settings.line_time = std::chrono::microseconds{60};
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth light = renderer.render(kHalfWay, 0).truth.lights[0];
  const double speed_px_per_s = 300.0 * 600.0 / 400.0;
  const double row_time_s = 239.5 * 60e-6;
  const double left_u_px = 319.5 + 600.0 * 50.0 / 400.0;  // the left lens centre sits 50 mm to the left
  EXPECT_NEAR(seconds(light.exposed_since_1970 - kHalfWay), row_time_s, 2e-9);
  EXPECT_NEAR(light.at.u_px, left_u_px + speed_px_per_s * row_time_s, 1e-6);
  const auto center_of_row = [&](int y) {
    return light_moments(renderer, {.left = 0, .top = y, .right = 639, .bottom = y}).center.u_px;
  };
  EXPECT_NEAR((center_of_row(244) - center_of_row(235)) / 9.0, speed_px_per_s * 60e-6, 1e-4);
}

TEST(RendererMotionTest, RollingShutterFollowsAFallingLightToItsRow) {
  SimulationSettings settings = moving_settings({0.0, 800.0, 0.0});
  settings.line_time = std::chrono::microseconds{60};
  const SimulatedWorld world = world_of(settings);
  const LightTruth light = render(world, Side::kLeft, kHalfWay).truth.lights[0];
  // v = 239.5 + 1200 px/s x 60 us x v
  const double v_px = 239.5 / (1.0 - 1200.0 * 60e-6);
  EXPECT_NEAR(light.at.v_px, v_px, 1e-4);
  EXPECT_NEAR(seconds(light.exposed_since_1970 - kHalfWay), v_px * 60e-6, 1e-8);
}

TEST(RendererMotionTest, SwayingLightIsWhereItsSineIsAndBlurredByItsSpeed) {
  SimulationSettings settings = moving_settings(Vec3::Zero());
  settings.scene.lights[0].sway = Sway{.reach_mm = {30.0, 0.0, 0.0}, .period = std::chrono::milliseconds{800}};
  const SimulatedWorld still = world_of(settings);
  settings.exposure = std::chrono::milliseconds{10};
  const SimulatedWorld world = world_of(settings);
  FrameRenderer sharp_renderer(still, Side::kLeft);
  FrameRenderer renderer(world, Side::kLeft);
  const double middle_u_px = 319.5 + 600.0 * 50.0 / 400.0;  // the left lens centre sits 50 mm to the left
  // 500 s are 625 periods: through the middle, and fastest; a quarter of a period later at the end, and at rest.
  EXPECT_NEAR(sharp_renderer.render(kHalfWay, 0).truth.lights[0].at.u_px, middle_u_px, 1e-6);
  EXPECT_NEAR(renderer.render(kHalfWay, 0).truth.lights[0].at.u_px, middle_u_px, 1e-6);
  const double length_px = 30.0 * 600.0 / 400.0 * 2.0 * std::numbers::pi / 0.8 * 0.010;  // 3.5 px
  const double blur_px2 = light_moments(renderer).variance_px2.x() - light_moments(sharp_renderer).variance_px2.x();
  EXPECT_NEAR(blur_px2, length_px * length_px / 12.0, 0.02);
  const Duration at_the_end = kHalfWay + std::chrono::milliseconds{200};
  EXPECT_NEAR(renderer.render(at_the_end, 0).truth.lights[0].at.u_px, middle_u_px + 30.0 * 600.0 / 400.0, 1e-6);
  sharp_renderer.render(at_the_end, 0);
  EXPECT_NEAR(light_moments(renderer).variance_px2.x(), light_moments(sharp_renderer).variance_px2.x(), 0.01);
}

TEST(RendererMotionTest, TruthOfTheTargetIsThatOfRowZero) {
  SimulationSettings settings = moving_settings({300.0, 0.0, 0.0});
  settings.line_time = std::chrono::microseconds{60};
  const SimulatedWorld world = world_of(settings);
  const Duration time = kHalfWay + std::chrono::milliseconds{100};
  const FrameTruth truth = render(world, Side::kRight, time).truth;
  EXPECT_EQ(truth.exposed_since_1970, time);
  EXPECT_EQ(truth.side, Side::kRight);
  EXPECT_NEAR(truth.reference_from_target.translation().x(), 30.0, 1e-9);
}

}  // namespace
}  // namespace tripoint
