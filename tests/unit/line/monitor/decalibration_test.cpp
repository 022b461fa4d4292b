#include "line/monitor/decalibration.h"

#include <cmath>
#include <iostream>
#include <numbers>

#include <gtest/gtest.h>

#include "bench/bump_score.h"
#include "geometry/triangulation.h"
#include "watched_target.h"

namespace tripoint {
namespace {

using testing::knocked_rig;
using testing::kWatchedLeds;
using testing::view_by;
using testing::watched_model;

constexpr double kTenthOfADegree_rad = 0.1 * std::numbers::pi / 180.0;
const Vec3 kYaw(0.0, kTenthOfADegree_rad, 0.0);

class DecalibrationTest : public ::testing::Test {
 protected:
  DecalibrationTest() { decalibration_.watch(model_); }

  void see(const TargetView& view) {
    now_ += std::chrono::milliseconds(33);
    Aligned seen = bench::as_seen(view, testing::kSpot_px);
    seen.at = now_;
    const Pairs pairs = match(seen, model_);
    decalibration_.learn(seen, pairs, pose_of_target(seen, pairs, model_), model_);
  }
  void see(const StereoCalibration& cameras, int views) {
    for (int i = 0; i < views; ++i) see(view_by(cameras, 7));
  }
  [[nodiscard]] Measurement judged() const {
    Measurement measurement;
    measurement.pose = TargetPose{};
    measurement.exposed = now_;
    return decalibration_.judged(measurement);
  }
  [[nodiscard]] bool alarmed() const { return judged().faults.contains(Fault::kDecalibration); }

  LineModel model_ = watched_model();
  Decalibration decalibration_;
  TimePoint now_ = TimePoint{} + std::chrono::seconds(100);
};

TEST_F(DecalibrationTest, AKnockRaisesAnAlarmThatTakesThePose) {
  see(default_rig(), 60);
  EXPECT_EQ(judged().faults, Faults{});
  EXPECT_TRUE(judged().pose);
  see(knocked_rig(kYaw), 60);  // at rest: what the views before the knock erred by fades from the sum first
  EXPECT_EQ(judged().faults, Faults{Fault::kDecalibration});
  EXPECT_FALSE(judged().pose);
}

TEST_F(DecalibrationTest, CamerasThatArePutBackClearIt) {
  see(knocked_rig(kYaw), 60);
  EXPECT_TRUE(alarmed());
  see(default_rig(), 300);
  EXPECT_FALSE(alarmed());
  EXPECT_TRUE(judged().pose);
}

TEST_F(DecalibrationTest, WithoutATargetAnAlarmStands) {
  see(knocked_rig(kYaw), 60);
  for (int i = 0; i < 300; ++i) see(TargetView{});
  EXPECT_TRUE(alarmed());
}

TEST_F(DecalibrationTest, AnAlarmStandsWhileWhatIsSeenCouldStillBeTurned) {
  see(knocked_rig(kYaw), 60);
  model_.target.points[0].uncertainty_mm = 5.0;  // the sides say nothing any more
  see(knocked_rig(kYaw), 300);
  EXPECT_TRUE(alarmed());
}

TEST_F(DecalibrationTest, ShortVisitsAddUp) {
  for (int visit = 0; visit < 5; ++visit) {
    now_ += std::chrono::seconds(20);
    see(knocked_rig(kYaw), 6);
  }
  EXPECT_TRUE(alarmed());
}

TEST_F(DecalibrationTest, WhatWasFoundIsNewsForTwoSeconds) {
  see(default_rig(), 60);
  EXPECT_TRUE(judged().decalibration_mm);
  now_ += std::chrono::seconds(3);
  EXPECT_FALSE(judged().decalibration_mm);
  EXPECT_FALSE(judged().side_length_error_mm);
}

TEST_F(DecalibrationTest, PointsOfAnAlarmHaveNoIdentity) {
  Measurement measurement;
  MeasuredPoint led;
  led.id = 2;
  measurement.points.push_back(led);
  see(default_rig(), 60);
  EXPECT_EQ(decalibration_.judged(measurement).points[0].id, 2);
  see(knocked_rig(kYaw), 60);
  EXPECT_EQ(decalibration_.judged(measurement).points[0].id, 0);
}

TEST_F(DecalibrationTest, TheSameModelAgainForgetsNothing) {
  see(knocked_rig(kYaw), 60);
  model_.calibration_fits = false;  // somebody plugs in another camera,
  decalibration_.watch(model_);
  model_.calibration_fits = true;  // and the right one again
  decalibration_.watch(model_);
  EXPECT_TRUE(alarmed());
}

TEST_F(DecalibrationTest, AnotherCalibrationBeginsAnew) {
  see(knocked_rig(kYaw), 60);
  model_.calibration = knocked_rig(kYaw);
  model_.rig = rig_of(model_.calibration).value();
  decalibration_.watch(model_);
  EXPECT_FALSE(alarmed());
  EXPECT_FALSE(judged().decalibration_mm);
  EXPECT_FALSE(judged().side_length_error_mm);
}

TEST_F(DecalibrationTest, TheEstimateIsWhatTheTargetIsMisplacedBy) {
  see(knocked_rig(kYaw), 120);
  const Rig before = rig_of(model_.calibration).value();
  const TargetView view = view_by(knocked_rig(kYaw), 7);
  const Vec3 middle_mm = view.rig_from_target * ((kWatchedLeds[0] + kWatchedLeds[1] + kWatchedLeds[2]) / 3.0);
  PerSide<MeasuredPixel> pixels;
  const Rig after = rig_of(knocked_rig(kYaw)).value();
  for (const Side side : kBothSides) {
    pixels[side].at = projected(after.cameras[side], after.camera_from_rig[side] * middle_mm).value();
  }
  const double misplaced_mm = (triangulated(before, pixels)->in_rig_mm - middle_mm).norm();
  EXPECT_GT(misplaced_mm, 1.0);
  EXPECT_NEAR(judged().decalibration_mm.value(), misplaced_mm, 0.03 * misplaced_mm);
}

TEST_F(DecalibrationTest, FewViewsSayNothing) {
  see(knocked_rig(kYaw), 3);
  EXPECT_FALSE(alarmed());
  EXPECT_FALSE(judged().decalibration_mm);
}

TEST_F(DecalibrationTest, OnePointWatchesNothing) {
  model_.target.points.clear();
  model_.target.points.push_back({.id = 1});
  decalibration_.watch(model_);
  const std::array<Vec3, 1> led{Vec3::Zero()};
  for (int i = 0; i < 60; ++i) see(view_by(default_rig(), 7, led));
  EXPECT_FALSE(judged().decalibration_mm);
}

TEST_F(DecalibrationTest, WhatTheCalibrationAdmitsIsNoAlarm) {
  model_.covariance.diagonal().segment<3>(18).setConstant(kTenthOfADegree_rad * kTenthOfADegree_rad);
  decalibration_.watch(model_);
  see(knocked_rig(kYaw), 60);
  EXPECT_FALSE(alarmed());
  EXPECT_GT(judged().decalibration_mm.value(), 1.0);
}

// Every unit has its own calibration and target in error; bench_bump knocks 200 times about each axis, and watches a
// day.
TEST(BumpTest, ATenthOfADegreeIsNoticedAboutEachAxis) {
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    double sum_s = 0.0;
    for (std::uint64_t i = 0; i < 8; ++i) {
      const Side side = kBothSides[i % 2];
      const double time_s =
          bench::seconds_to_alarm({kWatchedLeds}, {}, {side, kTenthOfADegree_rad * axis}, 50 * i, 60.0);
      EXPECT_LE(time_s, 4.0) << axis.transpose();
      sum_s += time_s;
    }
    std::cout << "turned about (" << axis.transpose() << "): noticed after " << sum_s / 8.0 << " s\n";
    EXPECT_LE(sum_s / 8.0, 1.0);
  }
}

TEST(BumpTest, NoAlarmInTwoMinutesAmongOtherLights) {
  EXPECT_EQ(bench::alarms_without_cause({kWatchedLeds}, {}, 1, 120.0), 0);
}

}  // namespace
}  // namespace tripoint
