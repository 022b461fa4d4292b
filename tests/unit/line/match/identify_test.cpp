#include "line/match/identify.h"

#include <cstdint>
#include <iostream>

#include <gtest/gtest.h>

#include "bench/identity_score.h"

namespace tripoint {
namespace {

using bench::identity_score;
using bench::IdentityScore;

constexpr int kViews = 3000;

IdentityScore scored(const bench::ScoredTarget& target, const ViewSettings& settings) {
  const IdentityScore score = identity_score(target.leds_mm, settings, 1, kViews);
  std::cout << target.name << ": " << score.found << " of " << score.whole << " found, " << score.wrong << " wrong\n";
  return score;
}

// None wrong in 3000 views says that fewer than 1 in 1000 are, at 95 %; bench_identity counts 100,000 of each.
TEST(IdentifyTest, AmongOtherLightsNearlyEveryTargetIsFoundAndNoneWrongly) {
  for (const bench::ScoredTarget& target : bench::scored_targets()) {
    const IdentityScore score = scored(target, {});
    EXPECT_GT(score.whole, 2000);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_GE(score.found, 0.99 * score.whole);
  }
}

TEST(IdentifyTest, AnImageInAMirrorIsNeverTheTargetThoughTheTargetIsHidden) {
  for (const bench::ScoredTarget& target : bench::scored_targets()) {
    const IdentityScore score = scored(target, {.most_others = 0, .hidden_share = 1.0, .mirror_share = 1.0});
    EXPECT_EQ(score.whole, 0);
    EXPECT_EQ(score.wrong, 0);
  }
}

TEST(IdentifyTest, AMirrorBesideTheTargetDoesNoHarm) {
  for (const bench::ScoredTarget& target : bench::scored_targets()) {
    const IdentityScore score = scored(target, {.most_others = 0, .hidden_share = 0.0, .mirror_share = 1.0});
    EXPECT_EQ(score.wrong, 0);
    EXPECT_GE(score.found, 0.99 * score.whole);
  }
}

TEST(IdentifyTest, CoarseSpotsMakeNoWrongIdentities) {
  for (const bench::ScoredTarget& target : bench::scored_targets()) {
    const IdentityScore score = scored(target, {.sigma_px = 0.4, .most_others = 2});
    EXPECT_EQ(score.wrong, 0);
    EXPECT_GE(score.found, 0.96 * score.whole);  // a small target, seen coarsely
  }
}

/// Three pairs at the places given, as exact as 0.1 px makes them.
FixedVector<PlacedPair, kMaxPlacedPairs> placed(const std::vector<Vec3>& places_mm) {
  FixedVector<PlacedPair, kMaxPlacedPairs> pairs;
  for (std::size_t i = 0; i < places_mm.size(); ++i) {
    PlacedPair pair;
    pair.index = {i, i};
    pair.in_rig_mm = places_mm[i];
    pair.covariance_mm2 = Vec3(0.002, 0.002, 0.13).asDiagonal();
    pair.epipolar_variance_px2 = 0.01;
    pairs.push_back(pair);
  }
  return pairs;
}

class IdentifyPairsTest : public ::testing::Test {
 protected:
  IdentifyPairsTest() {
    model.target.points.push_back({1, {0.0, 0.0, 0.0}, 0.05});
    model.target.points.push_back({2, {100.0, 0.0, 0.0}, 0.05});
    model.target.points.push_back({3, {64.0, 48.0, 0.0}, 0.05});
    model.rig.camera_from_rig.left.translation() = Vec3(50.0, 0.0, 0.0);
    model.rig.camera_from_rig.right.translation() = Vec3(-50.0, 0.0, 0.0);
  }
  IdentityVerdict verdict(const FixedVector<PlacedPair, kMaxPlacedPairs>& pairs) const {
    return identify({pairs.begin(), pairs.size()}, model).verdict;
  }

  LineModel model;
  // Half a turn about x: it shines towards the cameras.
  const std::vector<Vec3> facing{{64.0, -48.0, 400.0}, {0.0, 0.0, 400.0}, {100.0, 0.0, 400.0}};
  const std::vector<Vec3> away{{64.0, 48.0, 400.0}, {0.0, 0.0, 400.0}, {100.0, 0.0, 400.0}};
};

TEST_F(IdentifyPairsTest, EachPointHasItsPair) {
  const auto pairs = placed(facing);
  const Identification found = identify({pairs.begin(), pairs.size()}, model);
  ASSERT_EQ(found.verdict, IdentityVerdict::kUnique);
  EXPECT_EQ(found.best.pair_of_point[0], 1U);
  EXPECT_EQ(found.best.pair_of_point[1], 2U);
  EXPECT_EQ(found.best.pair_of_point[2], 0U);
  EXPECT_LT(found.best.chi2, 1e-6);
}

TEST_F(IdentifyPairsTest, WhatShinesAwayIsToldFromWhatIsNotThere) {
  EXPECT_EQ(verdict(placed(away)), IdentityVerdict::kFacesAway);
  EXPECT_EQ(verdict(placed({{64.0, -48.0, 400.0}, {0.0, 0.0, 400.0}, {110.0, 0.0, 400.0}})), IdentityVerdict::kNone);
  EXPECT_EQ(verdict(placed({{0.0, 0.0, 400.0}, {100.0, 0.0, 400.0}})), IdentityVerdict::kNone);
  EXPECT_EQ(verdict(placed({})), IdentityVerdict::kNone);
}

TEST_F(IdentifyPairsTest, WhereTheLedsAreDecidesWhetherTheyShineIntoTheCameras) {
  // The origin is so far behind the LEDs that the image in a mirror has its own behind the cameras.
  for (TargetPoint& point : model.target.points) point.in_target_mm.z() = 500.0;
  EXPECT_EQ(verdict(placed(facing)), IdentityVerdict::kUnique);
  EXPECT_EQ(verdict(placed(away)), IdentityVerdict::kFacesAway);
}

TEST_F(IdentifyPairsTest, AnLedThatShinesAnotherWayIsJudgedByItsOwn) {
  model.target.points[1].facing = -Vec3::UnitZ();
  EXPECT_EQ(verdict(placed(facing)), IdentityVerdict::kFacesAway);
}

TEST_F(IdentifyPairsTest, ManyLightsThatMightBeTheTargetAreAmbiguousInBoundedTime) {
  std::vector<Vec3> crowd;
  for (int i = 0; i < 144; ++i) crowd.emplace_back(2.0 * i - 144.0, 40.0 * (i % 2), 400.0 + i % 5);
  auto pairs = placed(crowd);
  for (PlacedPair& pair : pairs) pair.covariance_mm2 = 25.0 * Matrix3::Identity();
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kAmbiguous);
}

TEST_F(IdentifyPairsTest, TwoOrdersThatFitAreAmbiguous) {
  auto both = facing;
  both.emplace_back(64.03, -48.03, 400.3);  // another light beside an LED
  EXPECT_EQ(verdict(placed(both)), IdentityVerdict::kAmbiguous);
  both.back() = Vec3(70.0, -48.0, 400.0);
  EXPECT_EQ(verdict(placed(both)), IdentityVerdict::kUnique);
}

TEST_F(IdentifyPairsTest, OneSpotIsNotTwoPoints) {
  auto pairs = placed(facing);
  pairs[2].index.left = pairs[0].index.left;
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kNone);
}

TEST_F(IdentifyPairsTest, SpotsThatAreNotAlikeAreNotBelieved) {
  auto pairs = placed(facing);
  pairs[1].alike = false;
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kNone);
}

TEST_F(IdentifyPairsTest, APairOffItsEpipolarLineWeighs) {
  auto pairs = placed(facing);
  pairs[1].epipolar_px = 0.6;  // six standard deviations
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kNone);
}

// A calibration that may be wrong by a scale of 1 % explains what the spots alone do not.
TEST_F(IdentifyPairsTest, WhatTheCalibrationExplainsIsNoMisfit) {
  std::vector<Vec3> larger = facing;
  for (Vec3& place : larger) place *= 1.01;
  auto pairs = placed(larger);
  for (PlacedPair& pair : pairs) pair.covariance_mm2 = 0.01 * Matrix3::Identity();
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kNone);
  constexpr int kScale = 21;
  for (PlacedPair& pair : pairs) pair.place_by_calibration.col(kScale) = pair.in_rig_mm;
  model.covariance(kScale, kScale) = 0.01 * 0.01;
  EXPECT_EQ(verdict(pairs), IdentityVerdict::kUnique);
}

}  // namespace
}  // namespace tripoint
