#include "config/target_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace tripoint {
namespace {

using ::testing::HasSubstr;
using Points = std::vector<Vec3>;

std::string fault_of(const Points& points, const std::optional<Vec3>& facing = std::nullopt) {
  return shape_fault(points, facing).value_or("");
}

/// A triangle by its sides 0-1, 1-2, 2-0 (law of cosines), in the plane z = 7.
Points triangle(double a, double b, double c) {
  const double x = (a * a + c * c - b * b) / (2.0 * a);
  return {{0.0, 0.0, 7.0}, {a, 0.0, 7.0}, {x, std::sqrt(c * c - x * x), 7.0}};
}

Points with(Points points, const Vec3& another) {
  points.push_back(another);
  return points;
}

Points mended(Points points, const std::string& fault) {
  std::size_t point = 0;
  Vec3 place = Vec3::Zero();
  const std::size_t at = fault.find("move points[");
  EXPECT_NE(at, std::string::npos) << fault;
  if (at == std::string::npos) return points;
  EXPECT_EQ(std::sscanf(fault.c_str() + at, "move points[%zu] to [%lf, %lf, %lf]", &point, &place.x(), &place.y(),
                        &place.z()),
            4)
      << fault;
  points.at(point) = place;
  return points;
}

TEST(TargetShapeTest, ScaleneTrianglesServe) {
  for (const Points& points : {triangle(100, 80, 60), triangle(60, 54, 48), triangle(60, 50, 40)}) {
    EXPECT_EQ(fault_of(points), "");
  }
}

TEST(TargetShapeTest, FewerThanThreePointsAreNoShape) {
  EXPECT_EQ(fault_of({{0, 0, 0}}), "");
  EXPECT_EQ(fault_of({{0, 0, 0}, {60, 0, 0}}), "");
}

TEST(TargetShapeTest, EquilateralAndIsoscelesTrianglesAreRefusedByName) {
  EXPECT_THAT(fault_of(triangle(60, 60, 60)), HasSubstr("an equilateral triangle (sides 60.0, 60.0, 60.0 mm"));
  EXPECT_THAT(fault_of(triangle(60, 50, 50)), HasSubstr("an isosceles triangle (sides 60.0, 50.0, 50.0 mm"));
  EXPECT_THAT(fault_of(triangle(50, 60, 50)), HasSubstr("an isosceles"));
  EXPECT_THAT(fault_of(triangle(50, 50, 60)), HasSubstr("an isosceles"));
}

TEST(TargetShapeTest, SidesCountAsEqualUpToWhatCanBeToldApart) {
  EXPECT_THAT(fault_of(triangle(60, 50 + kAlike_mm - 0.01, 50)), HasSubstr("an isosceles"));
  EXPECT_EQ(fault_of(triangle(60, 50 + kAlike_mm + 0.01, 50)), "");
}

TEST(TargetShapeTest, PointsOnALineAreRefused) {
  EXPECT_THAT(fault_of({{0, 0, 0}, {30, 0, 0}, {90, 0, 0}}), HasSubstr("nearly on a line"));
  EXPECT_THAT(fault_of({{0, 0, 0}, {30, 9.9, 0}, {100, 0, 0}}), HasSubstr("10 % of the length"));
  EXPECT_EQ(fault_of({{0, 0, 0}, {30, 10.1, 0}, {100, 0, 0}}), "");
  EXPECT_THAT(fault_of({{0, 0, 0}, {1, 2, 3}, {10, 20, 30}, {40, 80, 120}}), HasSubstr("nearly on a line"));
}

TEST(TargetShapeTest, MoreThanThreePointsThatCanBeTurnedOntoThemselvesAreRefused) {
  const Points square{{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}};
  const Points rectangle{{0, 0, 0}, {70, 0, 0}, {70, 50, 0}, {0, 50, 0}};
  const Points tetrahedron{{30, 30, 30}, {30, -30, -30}, {-30, 30, -30}, {-30, -30, 30}};
  Points dozen;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6.0;
    dozen.emplace_back(80.0 * std::cos(angle), 80.0 * std::sin(angle), 0.0);
  }
  for (const Points& points : {square, rectangle, tetrahedron, dozen}) {
    EXPECT_THAT(fault_of(points), HasSubstr("they lie on themselves"));
  }
}

// Mirrored, such a target lies on itself; but nobody can turn it so.
TEST(TargetShapeTest, AMirrorImageIsNoTurn) {
  EXPECT_EQ(fault_of(with(triangle(60, 54, 48), {20, 15, 32})), "");
  EXPECT_EQ(fault_of({{-30, 0, 0}, {30, 0, 0}, {0, 50, 0}, {0, 10, 30}}), "");
}

TEST(TargetShapeTest, WhoeverDoesAsToldHasATargetThatServes) {
  const Points line{{0, 0, 0}, {30, 0, 0}, {90, 0, 0}};
  const Points square{{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}};
  for (const Points& points : {triangle(60, 60, 60), triangle(60, 50, 50), triangle(300, 299, 40), line, square}) {
    EXPECT_EQ(fault_of(mended(points, fault_of(points))), "");
  }
}

TEST(TargetShapeTest, WhatIsProposedLiesInThePlaneOfTheTarget) {
  const Points flat = triangle(60, 50, 50);
  for (const Vec3& point : mended(flat, fault_of(flat))) EXPECT_EQ(point.z(), 7.0);
  const Points line{{0, 0, 0}, {30, 0, 0}, {90, 0, 0}};
  for (const Vec3& point : mended(line, fault_of(line, Vec3::UnitY()))) EXPECT_EQ(point.y(), 0.0);
}

/// By trying all: an order of the points, other than their own, that a rigid motion brings them into.
bool has_another_order(const Points& points) {
  Eigen::Matrix3Xd own(3, points.size());
  Eigen::Matrix3Xd other(3, points.size());
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < points.size(); ++i) own.col(static_cast<Eigen::Index>(i)) = points[i];
  while (std::next_permutation(order.begin(), order.end())) {
    for (std::size_t i = 0; i < points.size(); ++i) other.col(static_cast<Eigen::Index>(i)) = points[order[i]];
    const Eigen::Matrix4d motion = Eigen::umeyama(own, other, false);
    const Eigen::Matrix3Xd moved = (motion.topLeftCorner<3, 3>() * own).colwise() + motion.topRightCorner<3, 1>();
    if ((moved - other).colwise().norm().maxCoeff() < 0.1) return true;
  }
  return false;
}

// Every other set is made of turns about an axis, so that it lies on itself; points are seldom alike by chance.
TEST(TargetShapeTest, TheVerdictIsThatOfTryingEveryOrder) {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> place(-60.0, 60.0);
  const auto anywhere = [&] { return Vec3(place(random), place(random), place(random)); };
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    Points points{anywhere(), anywhere(), anywhere(), anywhere()};
    const Vec3 axis = anywhere().normalized();
    const Eigen::AngleAxisd half_turn(std::numbers::pi, axis);
    if (i % 2 == 0) points = {points[0], half_turn * points[0], points[1], half_turn * points[1], 40.0 * axis};
    if (points[0].cross(axis).norm() < 10.0 || points[1].cross(axis).norm() < 10.0) continue;
    const bool fault = shape_fault(points, std::nullopt).has_value();
    if (fault) ++refused;
    if (has_another_order(points)) {
      EXPECT_TRUE(fault) << i;
    } else if (fault) {
      // Alike within what can be seen, not exactly: the order found must move some point by less than that.
      EXPECT_TRUE(i % 2 == 1) << i;
    }
  }
  EXPECT_GT(refused, 80);
  EXPECT_LT(refused, 110);
}

}  // namespace
}  // namespace tripoint
