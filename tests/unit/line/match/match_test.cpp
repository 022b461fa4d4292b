#include "line/match/match.h"

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"

namespace tripoint {
namespace {

using testing::webcam_model;

Aligned seen_at_rest(const LineModel& model, const std::vector<Vec3>& points) {
  Aligned seen;
  seen.due = seen.common_time = true;
  for (const Vec3& point : points) {
    for (const Side side : kBothSides) {
      const RawPixel at = testing::pixel_of(model, side, testing::at_rest(point), 0.0, 0.0);
      seen.points[side].push_back(AlignedPoint{testing::spot_at(at, 0.05), Vec2::Zero(), Matrix2::Zero()});
      ++seen.spots[side];
    }
  }
  return seen;
}

TEST(MatchTest, TheOnlyPairOfAOnePointTargetIsThatPoint) {
  LineModel model = webcam_model();
  model.target.points[0].id = 7;
  const Pairs found = match(seen_at_rest(model, {{10.0, 15.0, 400.0}}), model);
  EXPECT_TRUE(found.faults.empty());
  ASSERT_EQ(found.pairs.size(), 1U);
  EXPECT_EQ(found.pairs[0].id, 7);
  EXPECT_NEAR(found.pairs[0].epipolar_px, 0.0, 1e-9);
}

TEST(MatchTest, TwelvePointsFindTheirPartners) {
  const LineModel model = webcam_model();
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(-80.0 + 14.0 * i, -70.0 + 12.0 * i, 400.0);
  const Pairs found = match(seen_at_rest(model, points), model);
  EXPECT_EQ(found.pairs.size(), 12U);
  for (const Pair& pair : found.pairs) EXPECT_NEAR(pair.epipolar_px, 0.0, 1e-9);
}

TEST(MatchTest, AStraySpotInOnePictureDoesNotHideTheLight) {
  const LineModel model = webcam_model();
  Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
  seen.points.left.push_back(AlignedPoint{testing::spot_at({300.0, 400.0}, 0.05), Vec2::Zero(), Matrix2::Zero()});
  const Pairs found = match(seen, model);
  EXPECT_TRUE(found.faults.empty());
  EXPECT_EQ(found.pairs.size(), 1U);
}

TEST(MatchTest, TheVolumesDepthSettlesWhatTheEpipolarLineLeavesOpen) {
  LineModel model = webcam_model();
  const Vec3 eye = model.rig.camera_from_rig.left.inverse().translation();
  const Vec3 point{10.0, 15.0, 400.0};
  Aligned seen = seen_at_rest(model, {point, eye + 1.25 * (point - eye)});
  seen.points.left.truncate(1);
  EXPECT_TRUE(match(seen, model).faults.contains(Fault::kAmbiguous));
  model.volume = WorkingVolume{{-100.0, -100.0, 350.0}, {100.0, 100.0, 450.0}};
  EXPECT_TRUE(match(seen, model).faults.empty());
  EXPECT_EQ(match(seen, model).pairs.size(), 1U);
  model.volume->from_rig = Isometry3(Eigen::Translation3d(0.0, 0.0, -300.0));
  EXPECT_EQ(match(seen, model).faults, Faults{Fault::kOutsideVolume});
}

TEST(MatchTest, LightsOfDifferentSizeOrBrightnessAreNoPair) {
  const LineModel model = webcam_model();
  const auto with = [&](double left_sigma_px, double left_amplitude) {
    Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
    seen.points.left[0].seen.sigma_px = left_sigma_px;
    seen.points.left[0].seen.amplitude = left_amplitude;
    seen.points.right[0].seen.sigma_px = 1.5;
    seen.points.right[0].seen.amplitude = 50.0;
    return match(seen, model);
  };
  EXPECT_TRUE(with(1.5, 50.0).faults.empty());
  for (const double size : {2.99, 0.76}) EXPECT_TRUE(with(size, 50.0).faults.empty());
  for (const double size : {3.01, 0.74}) EXPECT_EQ(with(size, 50.0).faults, Faults{Fault::kGeometryGate});
  for (const double brightness : {199.0, 12.6}) EXPECT_TRUE(with(1.5, brightness).faults.empty());
  for (const double brightness : {201.0, 12.4}) EXPECT_EQ(with(1.5, brightness).faults, Faults{Fault::kGeometryGate});
}

TEST(MatchTest, UnlikeSpotOnTheSameLineLeavesThePairAmbiguous) {
  // Whichever of the two is the odd one: it may be the true light, changed by glare or by what stands before it.
  const LineModel model = webcam_model();
  const Vec3 eye = model.rig.camera_from_rig.left.inverse().translation();
  const Vec3 point{10.0, 15.0, 400.0};
  Aligned seen = seen_at_rest(model, {point, eye + 1.25 * (point - eye)});
  seen.points.left.truncate(1);
  seen.points.left[0].seen.sigma_px = 1.5;
  for (const std::size_t odd : {0U, 1U}) {
    for (std::size_t i = 0; i < 2; ++i) seen.points.right[i].seen.sigma_px = i == odd ? 4.0 : 1.5;
    const Pairs found = match(seen, model);
    EXPECT_TRUE(found.faults.contains(Fault::kAmbiguous)) << "odd one " << odd;
    EXPECT_TRUE(found.pairs.empty()) << "odd one " << odd;
  }
}

TEST(MatchTest, GlareAndAnotherScaleAreNotCompared) {
  const LineModel model = webcam_model();
  Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
  ImagePoint& left = seen.points.left[0].seen;
  ImagePoint& right = seen.points.right[0].seen;
  left.amplitude = 20.0;
  right.amplitude = 100.0;
  EXPECT_EQ(match(seen, model).faults, Faults{Fault::kGeometryGate});
  left.weak = true;
  EXPECT_TRUE(match(seen, model).faults.empty());
  left.sigma_px = 1.5;
  right.sigma_px = 5.0;
  EXPECT_EQ(match(seen, model).faults, Faults{Fault::kGeometryGate});
  right.saturated = true;
  EXPECT_TRUE(match(seen, model).faults.empty());
}

TEST(MatchTest, LedsThatAreKnownByTheirBlinkingPairWithThemselves) {
  LineModel model = webcam_model();
  model.target.points.push_back({2, Vec3(50.0, 0.0, 0.0), 0.05});
  const Vec3 eye = model.rig.camera_from_rig.left.inverse().translation();
  const Vec3 point{10.0, 15.0, 400.0};
  Aligned seen = seen_at_rest(model, {point, eye + 1.25 * (point - eye)});  // one spot on top of the other at the left
  EXPECT_TRUE(match(seen, model).pairs.empty());
  for (const Side side : kBothSides) {
    for (const std::uint16_t led : {std::uint16_t{1}, std::uint16_t{2}}) seen.points[side][led - 1U].seen.led = led;
  }
  const Pairs found = match(seen, model);
  ASSERT_EQ(found.pairs.size(), 2U);
  for (const Pair& pair : found.pairs) {
    EXPECT_EQ(pair.id, pair.points.left.seen.led);
    EXPECT_EQ(pair.id, pair.points.right.seen.led);
  }
}

TEST(MatchTest, ADifferentLedIsNoPartnerWhereverItLies) {
  const LineModel model = webcam_model();
  Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
  seen.points.left[0].seen.led = 1;
  seen.points.right[0].seen.led = 2;
  EXPECT_TRUE(match(seen, model).pairs.empty());
  EXPECT_FALSE(match(seen, model).faults.empty());
}

TEST(MatchTest, WhatAlignCouldNotFollowIsNotCalledUnseen) {
  const LineModel model = webcam_model();
  Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
  seen.points.right.clear();
  EXPECT_EQ(match(seen, model).faults, Faults{Fault::kNotSeenRight});
  seen.faults.insert(Fault::kTimingBound);
  EXPECT_TRUE(match(seen, model).faults.empty());
}

TEST(MatchTest, WithoutACommonTimeNothingIsMatched) {
  const LineModel model = webcam_model();
  Aligned seen = seen_at_rest(model, {{10.0, 15.0, 400.0}});
  seen.common_time = false;
  EXPECT_TRUE(match(seen, model).pairs.empty());
}

}  // namespace
}  // namespace tripoint
