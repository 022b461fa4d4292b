#include "line/detect/circle_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tripoint {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLargest_px = 200.0;
const Vec2 kCenter(317.3, 201.9);
constexpr double kRadius_px = 40.0;

/// So many points of an arc around +x, at equal angles.
std::vector<Vec2> arc(double opening_rad, std::size_t count = kOutlineDirections, double radius_px = kRadius_px) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle_rad = opening_rad * ((static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5);
    points.emplace_back(kCenter + radius_px * Vec2(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return points;
}

std::vector<Vec2> noisy(std::vector<Vec2> points, double sigma_px, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, sigma_px);
  for (Vec2& point : points) point += Vec2(noise(random), noise(random));
  return points;
}

Vec2 error_px(const CircleFit& fit) { return Vec2(fit.center.u_px, fit.center.v_px) - kCenter; }

void expect_exact(const std::vector<Vec2>& points) {
  const auto fit = fitted_circle(points, kLargest_px);
  ASSERT_TRUE(fit);
  EXPECT_LT(error_px(*fit).norm(), 1e-9);
  EXPECT_NEAR(fit->radius_px, kRadius_px, 1e-9);
}

/// Mean squares of the errors in x and y over many draws of noise, and the mean of what was stated.
struct Scatter {
  Vec2 squares_px2 = Vec2::Zero();
  Vec2 stated_px2 = Vec2::Zero();
};

Scatter scatter_of(const std::vector<Vec2>& points, double sigma_px) {
  constexpr int kDraws = 1000;
  std::mt19937 random(7);
  Scatter scatter;
  for (int i = 0; i < kDraws; ++i) {
    const auto fit = fitted_circle(noisy(points, sigma_px, random), kLargest_px);
    EXPECT_TRUE(fit);
    if (!fit) continue;
    scatter.squares_px2 += error_px(*fit).cwiseAbs2() / kDraws;
    scatter.stated_px2 += Vec2(fit->covariance_px2.diagonal()) / kDraws;
  }
  return scatter;
}

TEST(CircleFitTest, PointsOfACircleGiveIt) { expect_exact(arc(2.0 * kPi)); }
TEST(CircleFitTest, PointsOfAnArcGiveItsCircle) { expect_exact(arc(kPi)); }
TEST(CircleFitTest, EightPointsAreEnough) { expect_exact(arc(2.0 * kPi, 8)); }

TEST(CircleFitTest, SevenPointsAreNot) { EXPECT_FALSE(fitted_circle(arc(2.0 * kPi, 7), kLargest_px)); }
TEST(CircleFitTest, NoPointsAreNoCircle) { EXPECT_FALSE(fitted_circle({}, kLargest_px)); }

// The least squares of a whole circle: x has the variance 2 sigma^2 / n. A thousand draws tell it to 4.5 %.
TEST(CircleFitTest, OfAWholeCircleTheErrorIsThatOfLeastSquares) {
  constexpr double kSigma_px = 0.4;
  const Scatter scatter = scatter_of(arc(2.0 * kPi), kSigma_px);
  const double variance_px2 = 2.0 * kSigma_px * kSigma_px / kOutlineDirections;
  EXPECT_NEAR(scatter.squares_px2.x() / variance_px2, 1.0, 0.15);
  EXPECT_NEAR(scatter.squares_px2.y() / variance_px2, 1.0, 0.15);
  // Stated for points 3 px apart, of which a radius of 40 px has 84: 96/84, and 84/81 for what was fitted.
  EXPECT_NEAR(scatter.stated_px2.x() / variance_px2, 96.0 / 83.8 * 83.8 / 80.8, 0.1);
}

// Of half a circle around +x, n sums of cos^2, sin^2 and cos are n/2, n/2 and 2n/pi: x varies with 1/(1/2 - 4/pi^2).
TEST(CircleFitTest, OfHalfACircleTheErrorLiesAlongItsMiddle) {
  constexpr double kSigma_px = 0.2;
  const Scatter scatter = scatter_of(arc(kPi), kSigma_px);
  const double across_px2 = 2.0 * kSigma_px * kSigma_px / kOutlineDirections;
  const double along_px2 = across_px2 / 2.0 / (0.5 - 4.0 / (kPi * kPi));
  EXPECT_NEAR(scatter.squares_px2.x() / along_px2, 1.0, 0.15);
  EXPECT_NEAR(scatter.squares_px2.y() / across_px2, 1.0, 0.15);
  EXPECT_NEAR(scatter.stated_px2.x() / scatter.stated_px2.y(), along_px2 / across_px2, 0.1);
}

TEST(CircleFitTest, WhatLiesInsideDoesNotMoveIt) {
  std::vector<Vec2> points = arc(2.0 * kPi);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.2, 0.8);
  for (std::size_t i = 20; i < 60; ++i) points[i] = kCenter + share(random) * (points[i] - kCenter);
  expect_exact(points);
  EXPECT_EQ(fitted_circle(points, kLargest_px)->on_circle, 56U);
  EXPECT_EQ(fitted_circle(points, kLargest_px)->beyond, 0U);
}

TEST(CircleFitTest, WhatLiesBeyondIsCounted) {
  std::vector<Vec2> points = arc(2.0 * kPi);
  for (std::size_t i = 10; i < 25; ++i) points[i] = kCenter + 1.5 * (points[i] - kCenter);
  expect_exact(points);
  EXPECT_EQ(fitted_circle(points, kLargest_px)->beyond, 15U);
}

/// So many points on the circle, the rest in turn on three smaller ones.
std::vector<Vec2> partly_on(std::size_t count) {
  std::vector<Vec2> points = arc(2.0 * kPi);
  for (std::size_t i = count; i < points.size(); ++i) {
    points[i] = kCenter + 0.2 * (1.0 + static_cast<double>(i % 3)) * (points[i] - kCenter);
  }
  return points;
}

TEST(CircleFitTest, AThirdOfThePointsIsNotEnough) {
  EXPECT_FALSE(fitted_circle(partly_on(32), kLargest_px));
  expect_exact(partly_on(33));
}

TEST(CircleFitTest, PointsOnALineAreNoCircle) {
  std::vector<Vec2> points;
  for (int i = 0; i < 96; ++i) points.emplace_back(100.0 + i, 50.0 + 0.5 * i);
  EXPECT_FALSE(fitted_circle(points, kLargest_px));
}

TEST(CircleFitTest, OnePointManyTimesIsNoCircle) {
  EXPECT_FALSE(fitted_circle(std::vector<Vec2>(96, kCenter), kLargest_px));
}

TEST(CircleFitTest, ALargerCircleThanAskedForIsNotFound) {
  EXPECT_FALSE(fitted_circle(arc(2.0 * kPi), kRadius_px - 1.0));
  EXPECT_TRUE(fitted_circle(arc(2.0 * kPi), kRadius_px + 1.0));
}

// The picture of a sphere 20 degrees beside the axis: axes as 1 to 1/cos(20 degrees).
TEST(CircleFitTest, AnEllipseHasTheCentreOfItsCircle) {
  std::vector<Vec2> points;
  for (const Vec2& point : arc(2.0 * kPi)) {
    const Vec2 from_center = point - kCenter;
    points.emplace_back(kCenter + Vec2(from_center.x() / std::cos(20.0 * kPi / 180.0), from_center.y()));
  }
  const auto fit = fitted_circle(points, kLargest_px);
  ASSERT_TRUE(fit);
  EXPECT_LT(error_px(*fit).norm(), 1e-6);
  EXPECT_GT(fit->radius_px, kRadius_px);
  EXPECT_LT(fit->radius_px, kRadius_px / std::cos(20.0 * kPi / 180.0));
}

}  // namespace
}  // namespace tripoint
