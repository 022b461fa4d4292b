#include "line/pose/tilt.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

const std::vector<Vec3> kSquare{{-15.0, 15.0, 0.0}, {15.0, 15.0, 0.0}, {15.0, -15.0, 0.0}, {-15.0, -15.0, 0.0}};

/// On the axis of sight, turned about x.
Isometry3 tilted_by(double tilt_rad) {
  return Eigen::Translation3d(0.0, 0.0, 400.0) * Eigen::AngleAxisd(tilt_rad, Vec3::UnitX());
}

TEST(TiltTest, OnTheAxisOfSightTheOtherTiltIsTheOppositeOne) {
  EXPECT_LT((tilted_over(tilted_by(0.3), kSquare).matrix() - tilted_by(-0.3).matrix()).norm(), 1e-12);
}

TEST(TiltTest, TheTurnBetweenTwoPosesIsThatOfTheirRotations) {
  EXPECT_NEAR(turn_between_rad(tilted_by(0.3), tilted_by(-0.2)), 0.5, 1e-12);
  EXPECT_EQ(turn_between_rad(tilted_by(0.3), tilted_by(0.3)), 0.0);
}

TEST(TiltTest, AFitMayEndHalfTheWayToTheOtherTiltAndNoFurther) {
  const Matrix3 sharp_rad2 = 1e-6 * Matrix3::Identity();
  EXPECT_NEAR(reach_of_tilt_rad(tilted_by(0.3), tilted_by(-0.3), sharp_rad2), 0.3, 1e-12);
}

TEST(TiltTest, WhereBothTiltsAreOneAFitMayEndWhereNoiseTakesIt) {
  const Matrix3 blurred_rad2 = Vec3(4e-4, 4e-4, 1e-4).asDiagonal();
  EXPECT_NEAR(reach_of_tilt_rad(tilted_by(0.001), tilted_by(-0.001), blurred_rad2), 4.0 * 0.03, 1e-12);
}

}  // namespace
}  // namespace tripoint
