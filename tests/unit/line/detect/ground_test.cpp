#include "line/detect/ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <span>
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

TEST(GroundTest, RoughGroundIsCalledSo) {
  const Pictures pictures(sloped);
  const auto rough = [&](double noise) {
    return ground_plane(pictures.interleaved(), {100.0, 90.0}, kRadius_px, {.luma = 60.0, .noise = noise}).rough;
  };
  EXPECT_FALSE(rough(2.9));
  EXPECT_TRUE(rough(3.1));
}

TEST(GroundTest, StripesOfEitherDirectionAreNoGrain) {
  const auto wave = [](int x) { return 60.0 + 6.0 * std::sin(2.0 * std::numbers::pi * x / 10.0); };
  const Pictures across([&](int u, int) { return wave(u); });
  const Pictures down([&](int, int v) { return wave(v); });
  for (const Picture& picture : {across.interleaved(), down.interleaved()}) {
    const GroundPlane ground = ground_plane(picture, {100.0, 90.0}, kRadius_px, {.luma = 60.0, .noise = 5.0});
    EXPECT_LT(ground.grain, 0.5);  // rounding alone: 0.29
  }
}

TEST(GroundTest, PictureOfOneRowIsNotReadBeyond) {
  const std::vector<std::uint8_t> bytes(640, 128);
  const Picture picture =
      picture_of({.format = PixelFormat::kYuyv, .size = {320, 1}, .stride_bytes = 640, .data = std::span(bytes)});
  EXPECT_EQ(ground_plane(picture, {100.0, 0.0}, kRadius_px, kGround).slope, Vec2(0.0, 0.0));
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

/// The spot found on ground that slopes along the rows, and its error.
struct OnSlope {
  bool found = false;
  double error_px = 0.0;
  double stated_px = 0.0;
};

OnSlope led_on_slope(double slope, double sigma_px, double amplitude) {
  constexpr RawPixel kAt{150.3, 120.4};
  const auto shine = [&](int u, int v) {
    return std::exp(-0.5 * (std::pow(u - kAt.u_px, 2) + std::pow(v - kAt.v_px, 2)) / (sigma_px * sigma_px));
  };
  const auto ground = [&](int u) { return std::clamp(80.0 + slope * (u - kAt.u_px), 16.0, 150.0); };
  const Pictures pictures([&](int u, int v) { return ground(u) + amplitude * shine(u, v); },
                          [&](int u, int v) { return 128.0 + 90.0 * shine(u, v); });
  LedDetector detector{LedDetectorSettings{}};
  const Detection detection = detector.detect(pictures.interleaved(), {});
  if (detection.points.size() != 1) return {};
  const ImagePoint& point = detection.points[0];
  return {true, std::hypot(point.at.u_px - kAt.u_px, point.at.v_px - kAt.v_px), std::sqrt(point.covariance_px2(0, 0))};
}

TEST(GroundTest, LedOnSlopingGroundIsWhereItIs) {
  // Left in, the slope would shift the centre by 4 sigma^2 / A times 0.3 = 0.08 px. The rest is rounding.
  const OnSlope spot = led_on_slope(0.3, 2.0, 60.0);
  ASSERT_TRUE(spot.found);
  EXPECT_LT(spot.error_px, 0.025);
}

TEST(GroundTest, SlopeThatIsLeftInIsStated) {
  int found = 0;
  for (const double slope : {0.2, 0.4, 0.6, 0.8, 1.2}) {
    for (const double sigma_px : {2.0, 3.0, 4.0}) {
      for (const double amplitude : {25.0, 40.0, 80.0}) {
        const OnSlope spot = led_on_slope(slope, sigma_px, amplitude);
        found += spot.found ? 1 : 0;
        EXPECT_LE(spot.error_px, 2.5 * spot.stated_px) << slope << ", sigma " << sigma_px << ", A " << amplitude;
      }
    }
  }
  EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace tripoint
