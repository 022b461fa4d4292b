#include "line/gate/gate.h"

#include <limits>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Everything in order: a pose in the middle of the volume.
struct GateTest : public ::testing::Test {
  GateTest() {
    seen.due = seen.common_time = true;
    seen.at = time_from_ns(5'000'000'000);
    seen.exposure_began = time_from_ns(4'990'000'000);
    Pair pair;
    pair.id = 1;
    pair.epipolar_px = 0.05;
    pair.epipolar_sigma_px = 0.05;
    pairs.pairs.push_back(pair);
    TargetPose pose;
    pose.position_in_output_mm = Vec3(0.0, 0.0, 400.0);
    pose.noise.diagonal().setConstant(0.01);
    fit.pose = pose;
    MeasuredPoint point;
    point.id = 1;
    fit.points.push_back(point);
    model.volume = WorkingVolume{{-50.0, -50.0, 350.0}, {50.0, 50.0, 450.0}};
  }
  [[nodiscard]] Measurement passed() const { return gate(seen, pairs, fit, model); }

  Aligned seen;
  Pairs pairs;
  Fit fit;
  LineModel model;
};

TEST_F(GateTest, APoseWithoutFaultsPasses) {
  const Measurement measurement = passed();
  EXPECT_TRUE(measurement.faults.empty());
  EXPECT_TRUE(measurement.pose);
  EXPECT_EQ(measurement.exposed, seen.at);
  EXPECT_EQ(measurement.exposure_began, seen.exposure_began);
  EXPECT_TRUE(measurement.warnings.empty());
}

TEST_F(GateTest, WhatIsNoRotationIsAnInternalFault) {
  fit.pose->output_from_target = Matrix3(Eigen::AngleAxisd(2.0, Vec3(1.0, 2.0, 3.0).normalized()));
  EXPECT_TRUE(passed().pose);
  const Matrix3 mirrored = Vec3(1.0, 1.0, -1.0).asDiagonal();
  const Matrix3 flat = Vec3(1.0, 0.0, 0.0).asDiagonal();
  for (const Matrix3& wrong : {mirrored, flat, Matrix3(1.001 * Matrix3::Identity()), Matrix3(kNone * mirrored)}) {
    fit.pose->output_from_target = wrong;
    EXPECT_EQ(passed().faults, Faults{Fault::kInternal});
    EXPECT_FALSE(passed().pose);
  }
}

TEST_F(GateTest, WhatTimeDidGoesOnToTheRegistersAndTheLatch) {
  seen.skew_s = 0.007;
  seen.offset_sigma_s = 0.0001;
  EXPECT_FALSE(passed().timing.uncorrected_cost_mm);
  fit.uncorrected_cost_mm = 1.25;
  EXPECT_EQ(passed().timing.skew_s, 0.007);
  EXPECT_EQ(passed().timing.skew_sigma_s, 0.0001);
  EXPECT_EQ(passed().timing.uncorrected_cost_mm, 1.25);
}

TEST_F(GateTest, AnyFaultOfAnyStageHoldsThePoseBackButNotTheRest) {
  for (unsigned bit = 0; bit < kFaultNames.size(); ++bit) {
    const auto fault = static_cast<Fault>(bit);
    for (Faults* const faults : {&seen.faults, &pairs.faults, &fit.faults}) {
      *faults = Faults{fault};
      const Measurement measurement = passed();
      EXPECT_FALSE(measurement.pose) << kFaultNames[bit];
      EXPECT_TRUE(measurement.faults.contains(fault));
      EXPECT_EQ(measurement.points.size(), 1U);
      *faults = Faults{};
    }
  }
}

TEST_F(GateTest, NoPoseIsNeverWithoutACause) {
  fit.pose.reset();
  EXPECT_FALSE(passed().faults.empty());
}

TEST_F(GateTest, TheVolumesBorderBelongsToIt) {
  for (int axis = 0; axis < 3; ++axis) {
    fit.pose->position_in_output_mm = Vec3(0.0, 0.0, 400.0);
    fit.pose->position_in_output_mm[axis] = model.volume->max_mm[axis];
    EXPECT_TRUE(passed().pose);
    fit.pose->position_in_output_mm[axis] += 0.001;
    EXPECT_EQ(passed().faults, Faults{Fault::kOutsideVolume});
    fit.pose->position_in_output_mm[axis] = model.volume->min_mm[axis] - 0.001;
    EXPECT_EQ(passed().faults, Faults{Fault::kOutsideVolume});
  }
  model.volume->from_rig = model.output_from_rig;  // which is moved: the volume stays where it is
  model.output_from_rig = Isometry3(Eigen::Translation3d(100.0, 0.0, 0.0));
  fit.pose->position_in_output_mm = Vec3(149.0, 0.0, 400.0);
  EXPECT_TRUE(passed().pose);
  fit.pose->position_in_output_mm = Vec3(49.0, 0.0, 400.0);
  EXPECT_EQ(passed().faults, Faults{Fault::kOutsideVolume});
  model.volume.reset();
  EXPECT_TRUE(passed().pose) << "without a volume there is no such gate";
}

TEST_F(GateTest, TimeMayContributeUpToItsBound) {
  fit.timing_sigma_mm = model.limits.timing_bound_mm;
  EXPECT_TRUE(passed().pose);
  fit.timing_sigma_mm *= 1.001;
  EXPECT_EQ(passed().faults, Faults{Fault::kTimingBound});
  fit.timing_sigma_mm = kNone;
  EXPECT_TRUE(passed().faults.contains(Fault::kTimingBound));
}

TEST_F(GateTest, TheModelsFaultsAreAdded) {
  model.calibration_fits = false;
  EXPECT_EQ(passed().faults, Faults{Fault::kCalibrationDoesNotFit});
  model.calibrated = false;
  EXPECT_EQ(passed().faults, Faults{Fault::kNoCalibration});
}

TEST_F(GateTest, ACovarianceThatIsNoneIsInternal) {
  fit.pose->noise(1, 1) = 0.0;
  EXPECT_EQ(passed().faults, Faults{Fault::kInternal}) << "a position without uncertainty does not exist";
  fit.pose->noise(1, 1) = 0.01;
  fit.pose->shared(0, 2) = kNone;
  EXPECT_EQ(passed().faults, Faults{Fault::kInternal});
  EXPECT_TRUE(passed().points.empty());
}

TEST_F(GateTest, MarksOfTheSpotsBecomeWarnings) {
  fit.points[0].saturated = true;
  EXPECT_EQ(passed().warnings, Warnings{Warning::kSaturatedSpot});
  fit.points[0].weak = true;
  EXPECT_EQ(passed().warnings, (Warnings{Warning::kSaturatedSpot, Warning::kWeakSpot}));
  EXPECT_TRUE(passed().pose);
}

TEST_F(GateTest, AResidualBeyondItsChiSquareIsAWarning) {
  pairs.pairs[0].epipolar_px = 3.28 * 0.05;  // 10.76 < 10.83
  EXPECT_TRUE(passed().warnings.empty());
  pairs.pairs[0].epipolar_px = 3.30 * 0.05;  // 10.89
  EXPECT_EQ(passed().warnings, Warnings{Warning::kHighResidual});
  EXPECT_TRUE(passed().pose);
}

}  // namespace
}  // namespace tripoint
