#include "sim/spot.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr ImageSize kSize{.width_px = 96, .height_px = 80};
const std::vector<float> kDark(96 * 80, 0.0F);

/// Sums over the picture that give energy, centre and variance.
struct Moments {
  double energy = 0.0;
  Vec2 center_px = Vec2::Zero();
  Vec2 variance_px2 = Vec2::Zero();
};

Moments moments_of(const LightPlane& plane) {
  Moments sums;
  Vec2 squares = Vec2::Zero();
  for (int y = 0; y < kSize.height_px; ++y) {
    for (int x = 0; x < kSize.width_px; ++x) {
      const auto level = static_cast<double>(plane.row(y)[static_cast<std::size_t>(x)]);
      const Vec2 at(x, y);
      sums.energy += level;
      sums.center_px += level * at;
      squares += level * at.cwiseAbs2();
    }
  }
  sums.center_px /= sums.energy;
  sums.variance_px2 = squares / sums.energy - sums.center_px.cwiseAbs2();
  return sums;
}

GaussianSpot white_spot(RawPixel at, double sigma_px, double energy) {
  return {.at = at, .sigma_px = sigma_px, .energy = {energy, energy, energy}, .row_px = at.v_px};
}

/// Mean of the Gaussian over a pixel by brute force.
double pixel_by_quadrature(const GaussianSpot& spot, int x, int y) {
  constexpr int kSteps = 100;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double dx = x - 0.5 + (i + 0.5) / kSteps - spot.at.u_px;
      const double dy = y - 0.5 + (j + 0.5) / kSteps - spot.at.v_px;
      sum += std::exp(-(dx * dx + dy * dy) / (2.0 * spot.sigma_px * spot.sigma_px));
    }
  }
  const double peak = spot.energy[0] / (2.0 * std::numbers::pi * spot.sigma_px * spot.sigma_px);
  return peak * sum / (kSteps * kSteps);
}

TEST(SpotTest, TableOfTheNormalIntegralIsTrueToAMillionth) {
  const NormalIntegral normal;
  for (double z = -7.0; z <= 7.0; z += 0.00137) {
    const double exact = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    ASSERT_NEAR(static_cast<double>(normal(static_cast<float>(z))), exact, 1e-6) << z;
  }
}

TEST(SpotTest, PixelsHoldTheIntegralOfTheGaussian) {
  LightPlane plane(kSize, kDark);
  const GaussianSpot spot = white_spot({.u_px = 40.3, .v_px = 33.8}, 1.3, 10.0);
  plane.add(spot, NormalIntegral{});
  for (const auto& [x, y] : {std::pair{40, 34}, {41, 33}, {38, 34}, {43, 37}, {40, 30}}) {
    // midpoint quadrature with 100 steps a side: error below h^2/24 of the curvature, 1e-5 of the peak 0.94
    EXPECT_NEAR(static_cast<double>(plane.row(y)[static_cast<std::size_t>(x)]), pixel_by_quadrature(spot, x, y), 2e-5);
  }
}

TEST(SpotTest, EnergyCenterAndWidthAreTheClosedForm) {
  for (const double sigma_px : {0.7, 1.5, 4.0}) {
    LightPlane plane(kSize, kDark);
    plane.add(white_spot({.u_px = 47.21, .v_px = 39.63}, sigma_px, 25.0), NormalIntegral{});
    const Moments moments = moments_of(plane);
    // cut at five sigma: 1.2e-6 of the energy, weighted by 25 in the variance; sums of float values: 1e-5
    EXPECT_NEAR(moments.energy, 25.0, 25.0 * 2e-5);
    EXPECT_NEAR(moments.center_px.x(), 47.21, 1e-4);
    EXPECT_NEAR(moments.center_px.y(), 39.63, 1e-4);
    // a pixel adds the variance of its own width, 1/12
    const double variance_px2 = sigma_px * sigma_px + 1.0 / 12.0;
    EXPECT_NEAR(moments.variance_px2.x(), variance_px2, 1e-3 * variance_px2);
    EXPECT_NEAR(moments.variance_px2.y(), variance_px2, 1e-3 * variance_px2);
  }
}

TEST(SpotTest, EachPixelOfTheMosaicTakesItsOwnColour) {
  LightPlane plane(kSize, kDark);
  plane.add({.at = {.u_px = 20.5, .v_px = 20.5}, .sigma_px = 2.0, .energy = {8.0, 2.0, 1.0}, .row_px = 20.5},
            NormalIntegral{});
  // four pixels at the same distance from the centre differ by colour alone
  const double red = static_cast<double>(plane.row(20)[20]);
  EXPECT_NEAR(static_cast<double>(plane.row(20)[21]) / red, 2.0 / 8.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(plane.row(21)[20]) / red, 2.0 / 8.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(plane.row(21)[21]) / red, 1.0 / 8.0, 1e-5);
}

TEST(SpotTest, SidewaysMotionWithTheRowsShearsTheSpot) {
  LightPlane plane(kSize, kDark);
  GaussianSpot spot = white_spot({.u_px = 48.0, .v_px = 40.0}, 2.0, 100.0);
  spot.shift_px_per_row = {0.3, 0.0};
  plane.add(spot, NormalIntegral{});
  for (const int y : {36, 40, 43}) {
    double sum = 0.0;
    double weighted = 0.0;
    for (int x = 0; x < kSize.width_px; ++x) {
      const auto level = static_cast<double>(plane.row(y)[static_cast<std::size_t>(x)]);
      sum += level;
      weighted += level * x;
    }
    EXPECT_NEAR(weighted / sum, 48.0 + 0.3 * (y - 40), 1e-4) << y;
  }
}

TEST(SpotTest, MotionDownTheRowsStretchesTheSpot) {
  LightPlane plane(kSize, kDark);
  GaussianSpot spot = white_spot({.u_px = 48.0, .v_px = 40.0}, 2.5, 100.0);
  spot.shift_px_per_row = {0.0, 0.2};
  plane.add(spot, NormalIntegral{});
  const Moments moments = moments_of(plane);
  // Row y sees the spot at v + 0.2 (y - v): the profile is that of (1 - 0.2)(y - v), box of a pixel included.
  EXPECT_NEAR(moments.energy, 100.0 / 0.8, 125.0 * 1e-4);
  EXPECT_NEAR(std::sqrt(moments.variance_px2.y()), std::sqrt(2.5 * 2.5 + 1.0 / 12.0) / 0.8, 3e-3);
}

TEST(SpotTest, ElongatedSpotHasTheCovarianceOfItsAxes) {
  LightPlane plane(kSize, kDark);
  GaussianSpot spot = white_spot({.u_px = 47.4, .v_px = 40.7}, 2.0, 25.0);
  spot.elongation = 1.8;
  spot.elongation_angle_rad = 0.7;
  plane.add(spot, NormalIntegral{});
  const Moments moments = moments_of(plane);
  double across_px2 = 0.0;
  for (int y = 0; y < kSize.height_px; ++y) {
    for (int x = 0; x < kSize.width_px; ++x) {
      across_px2 += static_cast<double>(plane.row(y)[static_cast<std::size_t>(x)]) / 25.0 * (x - 47.4) * (y - 40.7);
    }
  }
  const double cosine = std::cos(0.7);
  const double sine = std::sin(0.7);
  EXPECT_NEAR(moments.energy, 25.0, 25.0 * 2e-5);
  EXPECT_NEAR(moments.center_px.x(), 47.4, 1e-4);
  EXPECT_NEAR(moments.center_px.y(), 40.7, 1e-4);
  // sigma^2 = 4: the axes' variances are 4 x 1.8 and 4 / 1.8; a pixel adds 1/12 to each side
  EXPECT_NEAR(moments.variance_px2.x(), 7.2 * cosine * cosine + 4.0 / 1.8 * sine * sine + 1.0 / 12.0, 5e-3);
  EXPECT_NEAR(moments.variance_px2.y(), 7.2 * sine * sine + 4.0 / 1.8 * cosine * cosine + 1.0 / 12.0, 5e-3);
  EXPECT_NEAR(across_px2, (7.2 - 4.0 / 1.8) * sine * cosine, 5e-3);
}

TEST(SpotTest, SpotAcrossTheBorderKeepsItsInnerHalf) {
  LightPlane plane(kSize, kDark);
  plane.add(white_spot({.u_px = -0.5, .v_px = 40.0}, 2.0, 10.0), NormalIntegral{});
  EXPECT_NEAR(moments_of(plane).energy, 5.0, 5.0 * 2e-5);
}

TEST(SpotTest, SpotFarOutsideChangesNothing) {
  LightPlane plane(kSize, kDark);
  plane.add(white_spot({.u_px = 1e6, .v_px = -1e6}, 2.0, 10.0), NormalIntegral{});
  EXPECT_EQ(moments_of(plane).energy, 0.0);
}

TEST(SpotTest, ClearBringsTheBackgroundBack) {
  std::vector<float> background(kDark.size());
  for (std::size_t i = 0; i < background.size(); ++i) background[i] = static_cast<float>(i % 17) * 0.01F;
  LightPlane plane(kSize, background);
  plane.add(white_spot({.u_px = 30.0, .v_px = 12.0}, 3.0, 10.0), NormalIntegral{});
  plane.clear();
  for (int y = 0; y < kSize.height_px; ++y) {
    for (std::size_t x = 0; x < 96; ++x) ASSERT_EQ(plane.row(y)[x], background[static_cast<std::size_t>(y) * 96 + x]);
  }
}

}  // namespace
}  // namespace tripoint
