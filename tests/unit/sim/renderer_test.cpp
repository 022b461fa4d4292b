#include "sim/renderer.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

TEST(RendererTest, EnergyOfTheCoreIsTheClosedForm) {
  const SimulatedWorld world = world_of(bare_settings());
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth light = renderer.render(kHalfWay, 0).truth.lights[0];
  const double expected = 2.0 * std::numbers::pi * light.core_sigma_px * light.core_sigma_px * light.peak;
  EXPECT_NEAR(light_moments(renderer).energy, expected, 3e-5 * expected);  // cut at five sigma, sums of floats
}

TEST(RendererTest, HaloAddsItsShareTimesItsArea) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights[0].halo_share = 0.02;
  settings.scene.lights[0].halo_widening = 4.0;
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const LightTruth light = renderer.render(kHalfWay, 0).truth.lights[0];
  const double core = 2.0 * std::numbers::pi * light.core_sigma_px * light.core_sigma_px * light.peak;
  EXPECT_NEAR(light_moments(renderer).energy, core * (1.0 + 0.02 * 16.0), 3e-5 * core);
}

TEST(RendererTest, EnergyFallsWithTheSquareOfTheDistance) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights[0].mount = Mount::kReference;
  const auto energy_at = [&](const Vec3& in_left_mm) {
    const Isometry3 rig_from_left = rig_of(settings.rig)->camera_from_rig.left.inverse();
    settings.scene.lights[0].place_mm = rig_from_left * in_left_mm;
    const SimulatedWorld world = world_of(settings);
    FrameRenderer renderer(world, Side::kLeft);
    renderer.render(kHalfWay, 0);
    return light_moments(renderer).energy;
  };
  EXPECT_NEAR(energy_at({0.0, 0.0, 300.0}) / energy_at({0.0, 0.0, 450.0}), 2.25, 2.25 * 6e-5);
}

// Vectors E: points in the left camera's frame and the pixels where they appear in both pictures.
TEST(RendererTest, TruthIsWhereThePublishedVectorsSay) {
  struct Vector {
    Vec3 in_left_mm;
    PerSide<RawPixel> at;
  };
  const std::array<Vector, 3> vectors{{
      {{10.0, -20.0, 400.0}, {{337.98368733203125, 206.40246006914063}, {285.8273993306818, 209.10910100889714}}},
      {{-60.0, 70.0, 350.0}, {{216.78637273421788, 361.02338511253646}, {152.54245994654536, 355.9255091224203}}},
      {{80.0, -90.0, 480.0}, {{424.9900449983322, 122.1697524840235}, {401.09975748371204, 122.40308994678554}}},
  }};
  SimulationSettings settings = bare_settings();
  settings.scene.lights[0].mount = Mount::kReference;
  for (const Vector& vector : vectors) {
    settings.scene.lights[0].place_mm = rig_of(settings.rig)->camera_from_rig.left.inverse() * vector.in_left_mm;
    const SimulatedWorld world = world_of(settings);
    for (const Side side : kBothSides) {
      const LightTruth light = render(world, side, kHalfWay).truth.lights[0];
      EXPECT_NEAR(light.at.u_px, vector.at[side].u_px, 1e-8);
      EXPECT_NEAR(light.at.v_px, vector.at[side].v_px, 1e-8);
      EXPECT_TRUE(light.visible);
    }
  }
}

/// Centre of the luma of a YUYV picture around the truth, black level taken off.
PictureMoments luma_moments(const RenderedFrame& frame, const Window& window) {
  return moments_of(
      [&](int x, int y) {
        return frame.pixels[static_cast<std::size_t>(y) * frame.stride_bytes + 2 * static_cast<std::size_t>(x)] - 16.0;
      },
      window);
}

/// Luma is rounded to whole steps: the standard deviation of the centre that follows, and four of them.
double rounding_tolerance_px(double energy, int reach_px) {
  double lever_px2 = 0.0;
  for (int d = -reach_px; d <= reach_px; ++d) lever_px2 += d * d * (2.0 * reach_px + 1.0);
  return 4.0 * std::sqrt(lever_px2 / 12.0) / energy;
}

TEST(RendererTest, CenterOfANoiselessLumaSpotIsTheTruth) {
  constexpr int kReach_px = 11;  // more than five sigma of 2 px
  for (const LinearColor& color : {LinearColor{1.0, 1.0, 1.0}, LinearColor{1.0, 0.06, 0.03}}) {
    SimulationSettings settings = bare_settings();
    settings.scene.lights[0].color = color;
    for (const double shift_mm : {0.0, 0.11, 0.37, 0.52, 0.83}) {
      settings.trajectory = straight({shift_mm, -0.7 * shift_mm, 400.0}, Vec3::Zero());
      const SimulatedWorld world = world_of(settings);
      const RenderedFrame frame = render(world, Side::kRight, kHalfWay);
      const RawPixel at = frame.truth.lights[0].at;
      const PictureMoments luma = luma_moments(frame, around(at, kReach_px));
      // Sampling red at every second pixel shifts the centre by less than 4 pi sigma^2/p exp(-2 pi^2 sigma^2/p^2):
      // 5e-7 px for sigma 1.9 and p = 2, nothing beside the rounding.
      const double tolerance_px = rounding_tolerance_px(luma.energy, kReach_px);
      EXPECT_NEAR(luma.center.u_px, at.u_px, tolerance_px) << shift_mm;
      EXPECT_NEAR(luma.center.v_px, at.v_px, tolerance_px) << shift_mm;
      EXPECT_LT(tolerance_px, 0.15);  // else the test would say nothing
    }
  }
}

TEST(RendererTest, BrightSpotClipsInRedAlone) {
  SimulationSettings settings = bare_settings();
  settings.scene = led_scene({Vec3::Zero()}, 3.0);
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const RawPixel at = renderer.render(kHalfWay, 0).truth.lights[0].at;
  std::array<int, 3> highest{};
  for (int y = static_cast<int>(at.v_px) - 3; y <= static_cast<int>(at.v_px) + 3; ++y) {
    for (int x = static_cast<int>(at.u_px) - 3; x <= static_cast<int>(at.u_px) + 3; ++x) {
      highest[bayer_channel(x, y)] = std::max<int>(highest[bayer_channel(x, y)], renderer.raw().row(y)[x]);
    }
  }
  EXPECT_EQ(highest[0], kClipCounts);
  // green at most 0.06 x 3 x (1 + 0.02 of halo) of clip, plus a wall of 2.75 %
  EXPECT_LT(highest[1], (0.06 * 3.0 * 1.02 + 0.0275) * kClipCounts + 1.0);
  EXPECT_LT(highest[2], highest[1]);
}

TEST(RendererTest, SameCallGivesTheSameBytesAndNoiseIsFresh) {
  SimulationSettings settings;
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  const std::vector<std::uint8_t> first = renderer.render(kHalfWay, 5).pixels;
  const std::vector<std::uint8_t> next = renderer.render(kHalfWay, 6).pixels;
  EXPECT_NE(first, next);
  EXPECT_EQ(first, renderer.render(kHalfWay, 5).pixels);
  EXPECT_EQ(first, render(world, Side::kLeft, kHalfWay, 5).pixels);
}

TEST(RendererTest, LightBehindTheCameraOrOutsideThePictureIsNotVisible) {
  SimulationSettings settings = bare_settings();
  settings.scene = led_scene({Vec3(0.0, 0.0, -900.0), Vec3(4000.0, 0.0, 0.0), Vec3::Zero()});
  const RenderedFrame frame = render(world_of(settings), Side::kLeft, kHalfWay);
  EXPECT_FALSE(frame.truth.lights[0].visible);
  EXPECT_FALSE(frame.truth.lights[1].visible);
  EXPECT_TRUE(frame.truth.lights[2].visible);
}

TEST(RendererTest, GreyFrameIsTheLuma) {
  SimulationSettings settings = bare_settings();
  const RenderedFrame yuyv = render(world_of(settings), Side::kLeft, kHalfWay);
  settings.format = PixelFormat::kGrey;
  const RenderedFrame grey = render(world_of(settings), Side::kLeft, kHalfWay);
  ASSERT_EQ(grey.pixels.size(), 640U * 480U);
  EXPECT_EQ(grey.stride_bytes, 640U);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) ASSERT_EQ(grey.pixels[i], yuyv.pixels[2 * i]);
}

TEST(RendererTest, FrameOfARenderingCarriesItsTimesAndBytes) {
  SimulationSettings settings = bare_settings();
  settings.line_time = std::chrono::microseconds{25};
  const RenderedFrame rendered = render(world_of(settings), Side::kRight, kHalfWay);
  const Frame frame = frame_of(rendered);
  EXPECT_EQ(frame.side, Side::kRight);
  EXPECT_EQ(frame.exposed, TimePoint{kHalfWay});
  EXPECT_EQ(frame.line_time, std::chrono::microseconds{25});
  EXPECT_EQ(frame.stride_bytes, 1280U);
  EXPECT_EQ(frame.data.size(), 640U * 480U * 2U);
}

}  // namespace
}  // namespace tripoint
