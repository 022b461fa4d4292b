#include "line/monitor/datum_watch.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/triangulation.h"
#include "line/monitor/decalibration.h"
#include "watched_target.h"

namespace tripoint {
namespace {

using testing::kSpot_px;

constexpr double kTenthOfADegree_rad = 0.1 * std::numbers::pi / 180.0;
const Vec3 kDatum{-120.0, 110.0, 620.0};
const Isometry3 kStays = Isometry3::Identity();

Isometry3 turned_by(const Vec3& turn_rad) {
  return Isometry3(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.stableNormalized()));
}

/// A rig of exactly known cameras and one LED as its target, which it does not see; turns are those of a camera about
/// its own lens, or of the whole rig about its origin.
class DatumWatchTest : public ::testing::Test {
 protected:
  DatumWatchTest() {
    model_ = bench::model_of(std::span(testing::kWatchedLeds).first(1), default_rig(), RigCovariance::Zero(), 0.0);
    model_.datum = Datum{kDatum, 0.2, 10.0};
    decalibration_.watch(model_);
  }

  /// The datum by cameras that moved: camera_after_from_camera_before, each.
  void see(const PerSide<Isometry3>& moved, int views, const Vec3& datum_mm = kDatum, double averaging = 1.0) {
    for (int i = 0; i < views; ++i) {
      now_ += std::chrono::milliseconds(33);
      Aligned seen;
      seen.due = seen.common_time = true;
      seen.at = now_;
      for (const Side side : kBothSides) {
        AlignedPoint point;
        point.seen.at = pixel(moved, side, datum_mm);
        point.seen.covariance_px2 = averaging * kSpot_px * kSpot_px * Matrix2::Identity();
        point.averaging = averaging;
        seen.points[side].push_back(point);
        ++seen.spots[side];
      }
      const Pairs pairs = match(seen, model_);
      decalibration_.learn(seen, pairs, pose_of_target(seen, pairs, model_), model_);
    }
  }
  void begin_anew() {
    decalibration_ = Decalibration{};
    decalibration_.watch(model_);
  }
  void see_no_light(int views) {
    for (int i = 0; i < views; ++i) {
      now_ += std::chrono::milliseconds(33);
      Aligned seen;
      seen.due = seen.common_time = true;
      seen.at = now_;
      const Pairs pairs = match(seen, model_);
      decalibration_.learn(seen, pairs, pose_of_target(seen, pairs, model_), model_);
    }
  }
  [[nodiscard]] RawPixel pixel(const PerSide<Isometry3>& moved, Side side, const Vec3& at_mm) const {
    return projected(model_.rig.cameras[side], moved[side] * model_.rig.camera_from_rig[side] * at_mm).value();
  }
  [[nodiscard]] Measurement judged() const {
    Measurement measurement;
    measurement.pose = TargetPose{};
    measurement.common_time = true;
    measurement.exposed = now_;
    return decalibration_.judged(measurement);
  }
  [[nodiscard]] bool alarmed() const { return judged().faults.contains(Fault::kDecalibration); }

  LineModel model_;
  Decalibration decalibration_;
  TimePoint now_ = TimePoint{} + std::chrono::seconds(100);
};

const PerSide<Isometry3> kUpright{kStays, kStays};
const PerSide<Isometry3> kYawedRight{kStays, turned_by({0.0, kTenthOfADegree_rad, 0.0})};

TEST_F(DatumWatchTest, ADatumAtItsPlaceWatchesTheMount) {
  EXPECT_FALSE(judged().mount_watched);
  see(kUpright, 3);
  EXPECT_FALSE(judged().mount_watched);
  see(kUpright, 1);
  EXPECT_TRUE(judged().mount_watched);
  EXPECT_FALSE(alarmed());
  EXPECT_TRUE(judged().pose);
  EXPECT_NEAR(judged().decalibration_mm.value(), 0.0, 1e-6);
}

TEST_F(DatumWatchTest, AYawOrPitchOfEitherCameraTakesThePoseWithinASecond) {
  for (const Side side : kBothSides) {
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY())}) {
      begin_anew();
      PerSide<Isometry3> knocked = kUpright;
      knocked[side] = turned_by(kTenthOfADegree_rad * axis);
      see(kUpright, 60);
      EXPECT_FALSE(alarmed());
      see(knocked, 30);
      EXPECT_TRUE(alarmed()) << name(side) << " " << axis.transpose();
      EXPECT_FALSE(judged().pose);
      EXPECT_FALSE(judged().mount_watched);
    }
  }
}

TEST_F(DatumWatchTest, BothCamerasThatMovedTogetherAreNoticed) {
  // The rig slides by 2 mm: no epipolar distance changes, and no target could show it.
  PerSide<Isometry3> slid;
  for (const Side side : kBothSides) {
    const Isometry3& camera = model_.rig.camera_from_rig[side];
    slid[side] = camera * Eigen::Translation3d(2.0, 0.0, 0.0) * camera.inverse();
  }
  see(kUpright, 60);
  see(slid, 30);
  EXPECT_TRUE(alarmed());
  EXPECT_NEAR(judged().decalibration_mm.value(), 2.0, 0.1);  // of ten views' mean over thirty, 0.9^30 is left
}

TEST_F(DatumWatchTest, SomebodyWhoMovesTheDatumLooksTheSame) {
  see(kUpright, 60);
  see(kUpright, 30, kDatum + Vec3(2.0, 0.0, 0.0));
  EXPECT_TRUE(alarmed());
}

TEST_F(DatumWatchTest, TheSizeIsWhatThatPlaceIsMismeasuredBy) {
  see(kYawedRight, 100);
  PerSide<MeasuredPixel> pixels;
  for (const Side side : kBothSides) pixels[side].at = pixel(kYawedRight, side, kDatum);
  const double misplaced_mm = (triangulated(model_.rig, pixels)->in_rig_mm - kDatum).norm();
  EXPECT_GT(misplaced_mm, 3.0);
  EXPECT_NEAR(judged().decalibration_mm.value(), misplaced_mm, 0.02 * misplaced_mm);  // to first order
}

TEST_F(DatumWatchTest, PutBackItEnds) {
  see(kYawedRight, 60);
  EXPECT_TRUE(alarmed());
  see(kUpright, 60);
  EXPECT_FALSE(alarmed());
  EXPECT_TRUE(judged().mount_watched);
}

TEST_F(DatumWatchTest, ADatumThatGoesOutEndsNoAlarm) {
  see(kYawedRight, 60);
  see_no_light(300);
  EXPECT_TRUE(alarmed());
}

TEST_F(DatumWatchTest, ADatumThatGoesOutIsNoFaultButWatchesNoMore) {
  see(kUpright, 60);
  see_no_light(9);
  EXPECT_TRUE(judged().mount_watched);
  see_no_light(1);
  EXPECT_FALSE(judged().mount_watched);
  see_no_light(50);
  EXPECT_TRUE(judged().decalibration_mm);
  see_no_light(2);
  EXPECT_FALSE(judged().decalibration_mm);
  EXPECT_FALSE(alarmed());
}

TEST_F(DatumWatchTest, ADatumThatShowsNowAndThenWatchesNothing) {
  for (int glimpse = 0; glimpse < 20; ++glimpse) {
    see(kUpright, 1);
    see_no_light(20);
    EXPECT_FALSE(judged().mount_watched) << glimpse;
  }
}

TEST_F(DatumWatchTest, WithoutACommonTimeNothingIsWatched) {
  see(kUpright, 60);
  Measurement lost;
  lost.exposed = now_;
  EXPECT_FALSE(decalibration_.judged(lost).mount_watched);
}

TEST_F(DatumWatchTest, WhatItsOwnUncertaintyAdmitsIsNoAlarm) {
  model_.datum->uncertainty_mm = 8.0;
  see(kYawedRight, 60);
  EXPECT_FALSE(alarmed());
  EXPECT_TRUE(judged().mount_watched);
  EXPECT_GT(judged().decalibration_mm.value(), 3.0);
}

TEST_F(DatumWatchTest, WhatTheCalibrationAdmitsIsNoAlarm) {
  // Cameras that never moved and are known by a yaw too little: the reference frame, which the place is in, is theirs.
  const Rig truth = rig_of(testing::knocked_rig({0.0, kTenthOfADegree_rad, 0.0})).value();
  PerSide<Isometry3> erring;
  for (const Side side : kBothSides) {
    erring[side] = truth.camera_from_rig[side] * model_.rig.camera_from_rig[side].inverse();
  }
  see(erring, 60);
  EXPECT_TRUE(alarmed());
  begin_anew();
  const Eigen::Matrix<double, 6, 3> by_turn = calibration_by_turn(model_.calibration);
  model_.covariance.bottomRightCorner<6, 6>() =
      kTenthOfADegree_rad * kTenthOfADegree_rad * by_turn * by_turn.transpose();
  see(erring, 60);
  EXPECT_FALSE(alarmed());
  EXPECT_GT(judged().decalibration_mm.value(), 3.0);
}

TEST_F(DatumWatchTest, TwoPicturesOfADatumAtRestSayNoMoreThanOne) {
  // A turn that one picture leaves just short of an alarm, by which half its variance would make one.
  const auto alarms = [this](double turn_rad, double averaging) {
    begin_anew();
    see({kStays, turned_by({turn_rad, 0.0, 0.0})}, 60, kDatum, averaging);
    return alarmed();
  };
  double turn_rad = kTenthOfADegree_rad;
  while (alarms(turn_rad, 1.0)) turn_rad *= 0.95;
  EXPECT_GT(turn_rad, 0.1 * kTenthOfADegree_rad);
  EXPECT_FALSE(alarms(turn_rad, 0.5));
  EXPECT_TRUE(alarms(turn_rad / 0.95, 0.5));
}

TEST_F(DatumWatchTest, AnAlarmStandsWhileTheDatumIsKnownTooBadlyToEndIt) {
  see(kYawedRight, 60);
  model_.datum->uncertainty_mm = 8.0;
  see(kYawedRight, 60);
  EXPECT_TRUE(alarmed());
}

TEST_F(DatumWatchTest, WhatWasSeenBeforeAPauseIsForgotten) {
  see(kUpright, 60);
  now_ += std::chrono::seconds(3);
  see(kYawedRight, 3);
  EXPECT_FALSE(judged().mount_watched);
  see(kYawedRight, 1);
  EXPECT_TRUE(alarmed());
}

TEST_F(DatumWatchTest, AnotherPlaceOfTheDatumBeginsAnew) {
  see(kYawedRight, 60);
  decalibration_.watch(model_);
  EXPECT_TRUE(alarmed());
  model_.datum->in_rig_mm.x() += 1.0;
  decalibration_.watch(model_);
  EXPECT_FALSE(alarmed());
}

}  // namespace
}  // namespace tripoint
