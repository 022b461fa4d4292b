#include "line/monitor/view_noise.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "line/monitor/decalibration.h"
#include "watched_target.h"

namespace tripoint {
namespace {

using testing::kSpot_px;
using testing::view_by;
using testing::watched_model;

const Matrix3 kOne = Matrix3::Identity();

std::vector<LocatedPoint> leds_at(double u_px, double averaging = 1.0) {
  std::vector<LocatedPoint> leds(2);
  for (std::size_t i = 0; i < leds.size(); ++i) {
    for (const Side side : kBothSides) leds[i].pixels[side].at = {u_px + 50.0 * static_cast<double>(i), 100.0};
    leds[i].averaging = averaging;
  }
  return leds;
}

double variance_after(int views, double step_px, double averaging = 1.0) {
  ViewNoise noise;
  for (int i = 0; i < views; ++i) noise.add(1.0, kOne, leds_at(step_px * i, averaging));
  return noise.covariance()(0, 0);
}

TEST(ViewNoiseTest, AtRestTheSumSpreadsWithTheNumberOfViews) {
  EXPECT_DOUBLE_EQ(variance_after(20, 0.0), 20.0 * 20.0);
  EXPECT_DOUBLE_EQ(variance_after(20, 0.04), 20.0 * 20.0) << "by less than a pixel altogether";
}

TEST(ViewNoiseTest, AtRestInterpolationBetweenTwoPicturesSaysNoMoreThanOne) {
  EXPECT_DOUBLE_EQ(variance_after(20, 0.0, 0.5), 2.0 * 20.0 * 20.0);
}

TEST(ViewNoiseTest, OfAMovingTargetTwoViewsCountAsOne) { EXPECT_DOUBLE_EQ(variance_after(20, 1.5), 2.0 * 20.0); }

TEST(ViewNoiseTest, OneLedThatStaysIsEnoughToErrAsItDid) {
  ViewNoise noise;
  for (int i = 0; i < 20; ++i) {
    std::vector<LocatedPoint> leds = leds_at(3.0 * i);
    leds[1].pixels.right.at = {400.0, 100.0};
    noise.add(1.0, kOne, leds);
  }
  EXPECT_DOUBLE_EQ(noise.covariance()(0, 0), 20.0 * 20.0);
}

TEST(ViewNoiseTest, AfterAMoveTheRestBeforeItStaysInTheSum) {
  ViewNoise noise;
  for (int i = 0; i < 10; ++i) noise.add(1.0, kOne, leds_at(0.0));
  for (int i = 0; i < 10; ++i) noise.add(1.0, kOne, leds_at(100.0));
  EXPECT_DOUBLE_EQ(noise.covariance()(0, 0), 2.0 * 10.0 * 10.0);
}

TEST(ViewNoiseTest, WhatFadesFromTheSumFadesFromItsNoise) {
  ViewNoise noise;
  for (int i = 0; i < 1000; ++i) noise.add(0.9, kOne, leds_at(0.0));
  EXPECT_NEAR(noise.covariance()(0, 0), 10.0 * 10.0, 1e-9);  // a sum of 10
}

// Parked, with the errors of its spots frozen: the larger the sum of views, the surer it would look.
TEST(ViewNoiseTest, AParkedTargetWhoseSpotsErrAsStatedRaisesNoAlarm) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, kSpot_px);
  int alarms = 0;
  for (std::uint64_t parked = 0; parked < 100; ++parked) {
    const LineModel model = watched_model();
    Decalibration decalibration;
    decalibration.watch(model);
    Aligned seen = bench::as_seen(view_by(default_rig(), 1 + parked), kSpot_px);
    for (const Side side : kBothSides) {
      for (AlignedPoint& point : seen.points[side]) {
        point.seen.at.u_px += normal(random);
        point.seen.at.v_px += normal(random);
      }
    }
    seen.at = TimePoint{} + std::chrono::seconds(100);
    for (int i = 0; i < 40; ++i) {
      seen.at += std::chrono::milliseconds(33);
      const Pairs pairs = match(seen, model);
      decalibration.learn(seen, pairs, pose_of_target(seen, pairs, model), model);
    }
    Measurement measurement;
    measurement.exposed = seen.at;
    if (decalibration.judged(measurement).faults.contains(Fault::kDecalibration)) ++alarms;
  }
  EXPECT_EQ(alarms, 0);
}

}  // namespace
}  // namespace tripoint
