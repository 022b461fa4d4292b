#include "line/monitor/motion.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TimePoint at(double time_s) { return TimePoint{duration_from_seconds(time_s)}; }

TargetPose pose_at(const Vec3& position, double sigma_mm = 0.1) {
  TargetPose pose;
  pose.position_in_output_mm = position;
  pose.noise.diagonal().head<3>().setConstant(sigma_mm * sigma_mm);
  return pose;
}

TEST(MotionTest, SpeedIsUnknownUntilTwoPositions) {
  Motion motion;
  EXPECT_FALSE(motion.speed_mm_per_s());
  EXPECT_FALSE(motion.position_at(at(1.0)));
  motion.take(at(1.0), pose_at({0.0, 0.0, 400.0}));
  EXPECT_FALSE(motion.speed_mm_per_s());
  motion.take(at(1.1), pose_at({30.0, 40.0, 400.0}));
  EXPECT_NEAR(*motion.speed_mm_per_s(), 500.0, 1e-9);
}

TEST(MotionTest, PredictsAlongAConstantVelocityWithGrowingVariance) {
  Motion motion;
  for (int i = 0; i <= 60; ++i) motion.take(at(i / 60.0), pose_at({100.0 * i / 60.0, 0.0, 400.0}));
  const auto soon = motion.position_at(at(1.02));
  const auto later = motion.position_at(at(1.10));
  ASSERT_TRUE(soon && later);
  EXPECT_NEAR(soon->in_output_mm.x(), 102.0, 1e-4);  // nanoseconds of rounding times 100 mm/s
  EXPECT_NEAR(later->in_output_mm.x(), 110.0, 1e-4);
  EXPECT_GT(soon->covariance_mm2(0, 0), 0.01);
  EXPECT_GT(later->covariance_mm2(0, 0), 10.0 * soon->covariance_mm2(0, 0));
}

TEST(MotionTest, AfterALongGapItBeginsAnew) {
  Motion motion;
  motion.take(at(1.0), pose_at({0.0, 0.0, 400.0}));
  motion.take(at(1.1), pose_at({10.0, 0.0, 400.0}));
  EXPECT_FALSE(motion.position_at(at(1.7)));
  motion.take(at(1.7), pose_at({90.0, 0.0, 400.0}));
  EXPECT_FALSE(motion.speed_mm_per_s());
}

TEST(MotionTest, ANoisyPointAtRestSettlesAndAMovingOneDoesNot) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  // 0.1 mm a position every 1/60 s and a memory of 50 ms leave about 0.1 sqrt(2) / 0.05 = 3 mm/s an axis
  constexpr double kLimit_mm_per_s = 20.0;
  Motion resting;
  Motion moving;
  for (int i = 0; i <= 120; ++i) {
    const Vec3 noise{0.1 * normal(random), 0.1 * normal(random), 0.1 * normal(random)};
    resting.take(at(i / 60.0), pose_at(Vec3(0.0, 0.0, 400.0) + noise));
    moving.take(at(i / 60.0), pose_at(Vec3(0.0, 40.0 * i / 60.0, 400.0) + noise));
    if (i < 12) {
      EXPECT_FALSE(resting.settled(kLimit_mm_per_s)) << "too early to tell";
    }
    if (i > 13) {
      EXPECT_TRUE(resting.settled(kLimit_mm_per_s)) << i;
    }
    EXPECT_FALSE(moving.settled(kLimit_mm_per_s)) << i;
  }
}

}  // namespace
}  // namespace tripoint
