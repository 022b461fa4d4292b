// A camera that was knocked shows in tags.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "bench/seen_tags.h"
#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::picture;
using testing::verdicts;

constexpr double kTenthOfADegree_rad = 0.1 * std::numbers::pi / 180.0;
constexpr int kSecond = 30;  // views
const Vec3 kUpright = Vec3::Zero();
const Vec3 kPitch(kTenthOfADegree_rad, 0.0, 0.0);
const Vec3 kYaw(0.0, kTenthOfADegree_rad, 0.0);
const Vec3 kRoll(0.0, 0.0, kTenthOfADegree_rad);

Isometry3 tilted() {
  Isometry3 pose(Eigen::Translation3d(15.0, -20.0, 410.0));
  pose.rotate(Eigen::AngleAxisd(0.5, Vec3(0.6, 0.8, 0.0)));
  return pose;
}

LineModel model_of(int tags) {
  LineModel model = testing::webcam_model();
  model.target = {};
  const std::vector<Vec3> places_mm{{-45.0, -10.0, 0.0}, {40.0, -25.0, 0.0}, {5.0, 50.0, 0.0}};
  for (int i = 0; i < tags; ++i) bench::add_tag(model.target, i, 40.0, places_mm[static_cast<std::size_t>(i)], 0.05);
  return model;
}

/// What is believed of cameras of which the right one stands turned about its own lens.
LineModel turned(LineModel model, const Vec3& turn_rad) {
  model.calibration.right_from_left.prerotate(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.stableNormalized()));
  model.rig = rig_of(model.calibration).value();
  return model;
}

/// Second by second, how the right camera stands.
std::vector<Measurement> seen(const LineModel& believed, const std::vector<Vec3>& turns_rad) {
  std::mt19937_64 random(5);
  std::vector<Event> events;
  int view = 0;
  for (const Vec3& turn_rad : turns_rad) {
    const LineModel cameras = turned(believed, turn_rad);
    for (int i = 0; i < kSecond; ++i, ++view) {
      for (const Side side : kBothSides) {
        Observation one = picture(side, static_cast<std::uint32_t>(view), 1.0 + view / 30.0);
        bench::add_tags(one, cameras, tilted(), {.edge_px = 0.02, .corner_px = 0.05}, random);
        events.emplace_back(one);
      }
    }
  }
  return verdicts(believed, events);
}

bool alarmed(const Measurement& one) { return one.faults.contains(Fault::kDecalibration); }

TEST(LineKnockedTagsTest, CamerasThatStandStillRaiseNoAlarm) {
  for (const int tags : {1, 3}) {
    const std::vector<Measurement> upright = seen(model_of(tags), std::vector<Vec3>(10, kUpright));
    EXPECT_EQ(std::count_if(upright.begin(), upright.end(), alarmed), 0) << tags;
    EXPECT_TRUE(upright.back().pose);
    EXPECT_LT(upright.back().decalibration_mm.value(), 1.0);
    EXPECT_NEAR(upright.back().side_length_error_mm.value(), 0.0, 0.05);
  }
}

TEST(LineKnockedTagsTest, APitchOrYawOfATenthOfADegreeIsNamedWithinASecondAndTakesThePose) {
  for (const Vec3& turn_rad : {kPitch, kYaw, Vec3(-kPitch), Vec3(-kYaw), Vec3(5.0 * kRoll)}) {
    const std::vector<Measurement> knocked = seen(model_of(3), {kUpright, kUpright, turn_rad, turn_rad});
    ASSERT_GT(knocked.size(), 100U);
    EXPECT_FALSE(alarmed(knocked[50]));
    EXPECT_TRUE(alarmed(knocked.back())) << turn_rad.transpose();
    EXPECT_FALSE(knocked.back().pose);
    EXPECT_TRUE(alarmed(knocked[3 * kSecond])) << turn_rad.transpose();
  }
}

// What moves all its edges inwards by a tenth of a pixel makes a tag as small as a yaw of 0.06 degrees does.
TEST(LineKnockedTagsTest, OneTagShowsAYawInItsSizeAndSaysByHowMuch) {
  const std::vector<Measurement> knocked = seen(model_of(1), {kUpright, kUpright, 2.0 * kYaw, 2.0 * kYaw});
  EXPECT_TRUE(alarmed(knocked.back()));
  EXPECT_GT(knocked.back().decalibration_mm.value(), 4.0);
  EXPECT_LT(knocked.back().decalibration_mm.value(), 10.0);
}

TEST(LineKnockedTagsTest, AYawThatOneTagShowsTooBadlyToNameItIsNoPoseEither) {
  const std::vector<Measurement> knocked = seen(model_of(1), {kUpright, kYaw, kYaw});
  for (std::size_t i = 2 * kSecond; i < knocked.size(); ++i) EXPECT_FALSE(knocked[i].pose) << i;
}

TEST(LineKnockedTagsTest, EdgesThatACameraShiftsInwardsAreNotTakenForAYaw) {
  const LineModel model = model_of(1);
  LineModel small = model;  // a tenth of a pixel on each side
  for (Vec3& corner_mm : small.target.tags[0].corners_mm) {
    const Vec3 centre_mm = model.target.points[0].in_target_mm;
    corner_mm = centre_mm + (1.0 - 0.2 / 62.0) * (corner_mm - centre_mm);
  }
  std::mt19937_64 random(5);
  std::vector<Event> events;
  for (int view = 0; view < 5 * kSecond; ++view) {
    for (const Side side : kBothSides) {
      Observation one = picture(side, static_cast<std::uint32_t>(view), 1.0 + view / 30.0);
      bench::add_tags(one, small, tilted(), {.edge_px = 0.02, .corner_px = 0.05}, random);
      events.emplace_back(one);
    }
  }
  const std::vector<Measurement> shrunk = verdicts(model, events);
  EXPECT_EQ(std::count_if(shrunk.begin(), shrunk.end(), alarmed), 0);
}

TEST(LineKnockedTagsTest, PutBackTheAlarmEnds) {
  std::vector<Vec3> turns_rad(2, kYaw);
  turns_rad.insert(turns_rad.end(), 8, kUpright);
  const std::vector<Measurement> knocked = seen(model_of(3), turns_rad);
  EXPECT_TRUE(alarmed(knocked[2 * kSecond - 5]));
  EXPECT_FALSE(alarmed(knocked.back()));
  EXPECT_TRUE(knocked.back().pose);
}

TEST(LineKnockedTagsTest, WhatTheTargetFileAdmitsIsNoAlarm) {
  LineModel model = model_of(1);
  model.target.tags[0].uncertainty_mm = 2.0;
  const std::vector<Measurement> knocked = seen(model, std::vector<Vec3>(4, kYaw));
  EXPECT_EQ(std::count_if(knocked.begin(), knocked.end(), alarmed), 0);
}

}  // namespace
}  // namespace tripoint
