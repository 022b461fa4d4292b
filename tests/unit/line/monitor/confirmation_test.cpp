#include "line/monitor/confirmation.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr double kPeriod_s = 1.0 / 60.0;

Measurement seen(int verdict, const Vec3& place_mm, double turn_rad = 0.0) {
  Measurement measurement;
  measurement.exposed = TimePoint{duration_from_seconds(100.0 + kPeriod_s * verdict)};
  TargetPose pose;
  pose.position_in_output_mm = place_mm;
  pose.output_from_target = Eigen::AngleAxisd(turn_rad, Vec3::UnitY()).toRotationMatrix();
  pose.noise.diagonal() << 0.01, 0.01, 0.01, 1e-6, 1e-6, 1e-6;
  measurement.pose = pose;
  return measurement;
}

const Vec3 kPlace(10.0, 20.0, 400.0);

bool believed(Confirmation& confirmation, const Measurement& measurement) {
  const Measurement judged = confirmation.judged(measurement);
  EXPECT_EQ(judged.pose.has_value(), judged.faults.empty());
  EXPECT_EQ(judged.pose ? Faults{Fault::kAmbiguous} : judged.faults, Faults{Fault::kAmbiguous});
  return judged.pose.has_value();
}

TEST(ConfirmationTest, TheFirstPoseIsBelievedWithTheSecond) {
  Confirmation confirmation;
  EXPECT_FALSE(believed(confirmation, seen(0, kPlace)));
  EXPECT_TRUE(believed(confirmation, seen(1, kPlace)));
  EXPECT_TRUE(believed(confirmation, seen(2, kPlace)));
}

TEST(ConfirmationTest, AChanceIsNotBelievedAndCostsTheTargetNothing) {
  Confirmation confirmation;
  for (int i = 0; i < 3; ++i) (void)confirmation.judged(seen(i, kPlace));
  EXPECT_FALSE(believed(confirmation, seen(3, kPlace + Vec3(60.0, 0.0, 0.0))));
  EXPECT_TRUE(believed(confirmation, seen(4, kPlace)));
  EXPECT_FALSE(believed(confirmation, seen(5, kPlace, 1.0)));
  EXPECT_TRUE(believed(confirmation, seen(6, kPlace)));
}

TEST(ConfirmationTest, ATargetThatMovesFastIsFollowed) {
  Confirmation confirmation;
  (void)confirmation.judged(seen(0, kPlace));
  const Vec3 step_mm(0.99 * Confirmation::kFastest_mm_per_s * kPeriod_s, 0.0, 0.0);
  for (int i = 1; i < 5; ++i) EXPECT_TRUE(believed(confirmation, seen(i, kPlace + i * step_mm, 0.16 * i)));
  EXPECT_FALSE(believed(confirmation, seen(5, kPlace + 6.1 * step_mm)));
}

TEST(ConfirmationTest, WhatNoiseExplainsIsNoContradiction) {
  Confirmation confirmation;
  (void)confirmation.judged(seen(0, kPlace));
  Measurement noisy = seen(1, kPlace + Vec3(45.0, 0.0, 0.0));
  EXPECT_FALSE(believed(confirmation, noisy));
  (void)confirmation.judged(seen(2, kPlace));
  noisy = seen(3, kPlace + Vec3(45.0, 0.0, 0.0));
  noisy.pose->noise(0, 0) = 10.0 * 10.0;
  EXPECT_TRUE(believed(confirmation, noisy));
}

TEST(ConfirmationTest, NoAbsenceAndNoNoiseAllowAnyPose) {
  Confirmation confirmation;
  for (int i = 0; i < 3; ++i) (void)confirmation.judged(seen(i, kPlace));
  EXPECT_FALSE(believed(confirmation, seen(14, kPlace + Vec3(60.0, 0.0, 0.0)))) << "0.2 s at 2 m/s would be 400 mm";
  EXPECT_FALSE(believed(confirmation, seen(15, kPlace, 0.4)));
  Measurement noisy = seen(16, kPlace + Vec3(60.0, 0.0, 0.0));
  noisy.pose->noise(0, 0) = 100.0 * 100.0;
  EXPECT_FALSE(believed(confirmation, noisy));
  EXPECT_TRUE(believed(confirmation, seen(17, kPlace + Vec3(10.0, 0.0, 0.0)))) << "as the last that was believed";
}

TEST(ConfirmationTest, OnlyTheVerdictJustBeforeConfirmsWhatNobodyBelieved) {
  Confirmation confirmation;
  (void)confirmation.judged(seen(0, kPlace));
  Measurement without = seen(1, kPlace);
  without.pose.reset();
  without.common_time = true;
  (void)confirmation.judged(without);
  EXPECT_FALSE(believed(confirmation, seen(2, kPlace)));
  without.common_time = false;  // a camera's silence is no verdict on the target
  without.exposed = seen(3, kPlace).exposed;
  (void)confirmation.judged(without);
  EXPECT_TRUE(believed(confirmation, seen(4, kPlace)));
}

TEST(ConfirmationTest, PointsOfAPoseThatNothingConfirmsHaveNoIdentity) {
  Confirmation confirmation;
  for (const int expected : {0, 7}) {
    Measurement measurement = seen(expected, kPlace);
    MeasuredPoint point;
    point.id = 7;
    measurement.points.push_back(point);
    EXPECT_EQ(confirmation.judged(measurement).points[0].id, expected);
  }
}

TEST(ConfirmationTest, AfterALongAbsenceTheFirstIsAFirstAgain) {
  Confirmation confirmation;
  for (int i = 0; i < 3; ++i) (void)confirmation.judged(seen(i, kPlace));
  EXPECT_FALSE(believed(confirmation, seen(40, kPlace)));
  EXPECT_TRUE(believed(confirmation, seen(41, kPlace)));
  confirmation.forget();
  EXPECT_FALSE(believed(confirmation, seen(42, kPlace)));
}

TEST(ConfirmationTest, APositionOfOneLedAndAVerdictWithoutAPosePass) {
  Confirmation confirmation;
  Measurement measurement = seen(0, kPlace);
  measurement.pose->output_from_target.reset();
  EXPECT_TRUE(believed(confirmation, measurement));
  measurement.pose.reset();
  measurement.faults.insert(Fault::kNotSeenLeft);
  EXPECT_EQ(confirmation.judged(measurement).faults, Faults{Fault::kNotSeenLeft});
}

}  // namespace
}  // namespace tripoint
