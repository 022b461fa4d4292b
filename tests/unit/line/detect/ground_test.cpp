#include "line/detect/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

constexpr ImageSize kSize{320, 240};
constexpr double kRadius_px = 2.2;
constexpr Ground kGround{.luma = 60.0, .noise = 0.5};
// Rounding to whole steps is noise of 0.29; the ring has some 100 pixels that lie 11 px RMS from its middle along each
// axis: 0.29 / (11 sqrt(100)) = 0.003, and 3 of them.
constexpr double kOfRounding = 0.008;

using Level = std::function<double(int u, int v)>;  ///< of a pixel

/// The same levels as the luma of a YUYV buffer and as a plane of its own.
class Pictures {
 public:
  Pictures(const Level& luma, const Level& red) {
    const auto pixels = static_cast<std::size_t>(kSize.width_px) * kSize.height_px;
    yuyv_.resize(2 * pixels, 128);
    plane_.resize(pixels);
    for (int v = 0; v < kSize.height_px; ++v) {
      for (int u = 0; u < kSize.width_px; ++u) {
        const std::size_t i = static_cast<std::size_t>(v) * kSize.width_px + static_cast<std::size_t>(u);
        plane_[i] = yuyv_[2 * i] = static_cast<std::uint8_t>(std::lround(luma(u, v)));
        if (u % 2 == 1) yuyv_[2 * i + 1] = static_cast<std::uint8_t>(std::lround(0.5 * (red(u - 1, v) + red(u, v))));
      }
    }
  }
  explicit Pictures(const Level& luma) : Pictures(luma, [](int, int) { return 128.0; }) {}

  [[nodiscard]] Picture interleaved() const {
    return picture_of({.format = PixelFormat::kYuyv,
                       .size = kSize,
                       .stride_bytes = 2 * static_cast<std::size_t>(kSize.width_px),
                       .data = yuyv_});
  }
  [[nodiscard]] Picture planar() const {
    return {.size = kSize, .luma = {plane_.data(), static_cast<std::size_t>(kSize.width_px), 1}, .u = {}, .v = {}};
  }

 private:
  std::vector<std::uint8_t> yuyv_;
  std::vector<std::uint8_t> plane_;
};

double sloped(int u, int v) { return 60.0 + 0.31 * (u - 100) - 0.17 * (v - 90); }

void expect_slope(const Vec2& slope, const Vec2& expected) {
  EXPECT_NEAR(slope.x(), expected.x(), kOfRounding);
  EXPECT_NEAR(slope.y(), expected.y(), kOfRounding);
}

TEST(GroundTest, SlopeOfAPlaneIsFoundInBothLayouts) {
  const Pictures pictures(sloped);
  const Ground ground{.luma = 60.0, .noise = 2.5};  // as the surround of a slope states it
  for (const Picture& picture : {pictures.interleaved(), pictures.planar()}) {
    expect_slope(ground_plane(picture, {100.3, 89.6}, kRadius_px, ground).slope, {0.31, -0.17});
    expect_slope(ground_plane(picture, {101.0, 90.0}, kRadius_px, ground).slope, {0.31, -0.17});
  }
}

TEST(GroundTest, WhatStandsOutOfTheRingIsLeftAside) {
  const auto with_neighbour = [](int u, int v) {
    return 60.0 + 0.1 * (u - 100) + (std::hypot(u - 112, v - 88) < 4.0 ? 90.0 : 0.0);
  };
  const Pictures pictures(with_neighbour);
  expect_slope(ground_plane(pictures.interleaved(), {100.0, 90.0}, kRadius_px, kGround).slope, {0.1, 0.0});
}

TEST(GroundTest, StepInTheRingIsNoSlope) {
  const Pictures pictures([](int u, int) { return u > 108 ? 75.0 : 60.0; });
  expect_slope(ground_plane(pictures.interleaved(), {100.0, 90.0}, kRadius_px, kGround).slope, {0.0, 0.0});
}

TEST(GroundTest, RoughGroundIsLeftAlone) {
  const Pictures pictures(sloped);
  EXPECT_EQ(ground_plane(pictures.interleaved(), {100.0, 90.0}, kRadius_px, {.luma = 60.0, .noise = 3.1}).slope,
            Vec2(0.0, 0.0));
}

TEST(GroundTest, GrainIsTheNoiseFromPixelToPixelAndNoPattern) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 3.0);
  const Pictures noisy([&](int, int) { return 60.0 + noise(random); });
  const Pictures patterned([](int u, int v) { return 60.0 + 4.0 * std::sin(0.25 * u) * std::cos(0.2 * v); });
  const Ground ground{.luma = 60.0, .noise = 3.0};
  // From some 100 differences: 3 sqrt(1 / 100) = 0.3, and 3 of them. Rounding adds 0.29 in squares.
  EXPECT_NEAR(ground_plane(noisy.interleaved(), {100.0, 90.0}, kRadius_px, ground).grain, 3.0, 0.9);
  // Two rows apart the pattern changes by 0.4 of a step of its 4 at most: 1.6 / sqrt(2) at its steepest.
  EXPECT_LT(ground_plane(patterned.interleaved(), {100.0, 90.0}, kRadius_px, ground).grain, 0.8);
}

TEST(GroundTest, TooFewPixelsOfTheGroundGiveNoSlope) {
  const Pictures pictures([](int u, int v) { return std::hypot(u - 100, v - 90) < 18.5 ? 200.0 : 60.0; });
  EXPECT_EQ(ground_plane(pictures.interleaved(), {100.0, 90.0}, kRadius_px, kGround).slope, Vec2(0.0, 0.0));
}

TEST(GroundTest, AtEveryBorderTheSlopeOfWhatShowsIsFound) {
  for (const RawPixel at : {RawPixel{9.0, 9.0}, RawPixel{310.0, 8.0}, RawPixel{8.0, 231.0}, RawPixel{311.0, 230.0}}) {
    const Pictures pictures([&](int u, int v) { return 60.0 + 0.2 * (u - at.u_px) - 0.1 * (v - at.v_px); });
    for (const Picture& picture : {pictures.interleaved(), pictures.planar()}) {
      const Vec2 slope = ground_plane(picture, at, kRadius_px, {.luma = 60.0, .noise = 2.0}).slope;
      // Half of the ring shows, to one side: its pixels spread half as wide, three times the noise of a whole one.
      EXPECT_NEAR(slope.x(), 0.2, 3.0 * kOfRounding) << at.u_px << ", " << at.v_px;
      EXPECT_NEAR(slope.y(), -0.1, 3.0 * kOfRounding) << at.u_px << ", " << at.v_px;
    }
  }
}

TEST(GroundTest, LedOnSlopingGroundIsWhereItIs) {
  constexpr RawPixel kAt{150.3, 120.4};
  constexpr double kSigma_px = 2.0;
  const auto shine = [&](int u, int v) {
    return std::exp(-0.5 * (std::pow(u - kAt.u_px, 2) + std::pow(v - kAt.v_px, 2)) / (kSigma_px * kSigma_px));
  };
  const Pictures pictures([&](int u, int v) { return 45.0 + 0.3 * (u - kAt.u_px) + 60.0 * shine(u, v); },
                          [&](int u, int v) { return 128.0 + 90.0 * shine(u, v); });
  LedDetector detector{LedDetectorSettings{}};
  const Detection detection = detector.detect(pictures.interleaved(), {});
  ASSERT_EQ(detection.points.size(), 1U);
  // Left in, the slope would shift the centre by 4 sigma^2 / A times 0.3 = 0.08 px. The rest is rounding.
  EXPECT_NEAR(detection.points[0].at.u_px, kAt.u_px, 0.02);
  EXPECT_NEAR(detection.points[0].at.v_px, kAt.v_px, 0.02);
}

}  // namespace
}  // namespace tripoint
