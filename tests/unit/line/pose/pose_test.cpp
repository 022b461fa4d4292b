#include "line/pose/pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"
#include "line/pose/output_frame.h"
#include "line/pose/timing_part.h"

namespace tripoint {
namespace {

using testing::webcam_model;

const Vec3 kPoint{20.0, -35.0, 410.0};

PerSide<RawPixel> pixels_of(const LineModel& model, const Vec3& point) {
  return {testing::pixel_of(model, Side::kLeft, testing::at_rest(point), 0.0, 0.0),
          testing::pixel_of(model, Side::kRight, testing::at_rest(point), 0.0, 0.0)};
}

Pair pair_at(const LineModel& model, const Vec3& point, int id) {
  const PerSide<RawPixel> at = pixels_of(model, point);
  Pair pair;
  pair.id = id;
  for (const Side side : kBothSides) pair.points[side].seen = testing::spot_at(at[side], 0.05);
  return pair;
}

Fit fit_of(const LineModel& model, const Pair& pair, double skew_s = 0.0) {
  Aligned seen;
  seen.common_time = true;
  seen.skew_s = skew_s;
  Pairs pairs;
  pairs.pairs.push_back(pair);
  return pose_of_target(seen, pairs, model);
}

TEST(PoseTest, BothMethodsFindThePointInTheOutputFrame) {
  for (const Method method : {Method::kMaximumLikelihood, Method::kPaper}) {
    LineModel model = webcam_model();
    model.method = method;
    model.output_from_rig = Eigen::Translation3d(100.0, 200.0, 300.0) * Eigen::AngleAxisd(0.5, Vec3::UnitY());
    const Fit fit = fit_of(model, pair_at(model, kPoint, 1));
    ASSERT_TRUE(fit.pose);
    EXPECT_LT((fit.pose->position_in_output_mm - model.output_from_rig * kPoint).norm(), 1e-6);
    EXPECT_FALSE(fit.pose->output_from_target);
    EXPECT_LT(fit.residual_rms_px, 1e-6);
    ASSERT_EQ(fit.points.size(), 1U);
    EXPECT_EQ(fit.points[0].id, 1);
  }
}

TEST(PoseTest, OneIdentifiedPointOfSeveralIsNoPose) {
  LineModel model = webcam_model();
  model.target.points.push_back({2, Vec3(50.0, 0.0, 0.0), 0.05});
  const Fit fit = fit_of(model, pair_at(model, kPoint, 1));
  EXPECT_FALSE(fit.pose);
  ASSERT_EQ(fit.points.size(), 1U);
  EXPECT_EQ(fit.points[0].id, 1);
}

TEST(PoseTest, TheCovarianceTurnsWithTheFrame) {
  LineModel model = webcam_model();
  const Matrix3 plain = fit_of(model, pair_at(model, kPoint, 1)).pose->noise.topLeftCorner<3, 3>();
  model.output_from_rig = Isometry3(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY()));  // depth becomes x
  const Matrix3 turned = fit_of(model, pair_at(model, kPoint, 1)).pose->noise.topLeftCorner<3, 3>();
  EXPECT_NEAR(turned(0, 0), plain(2, 2), 1e-9);
  EXPECT_NEAR(turned(2, 2), plain(0, 0), 1e-9);
}

TEST(PoseTest, HowWellTheLedIsMountedIsPartOfThePosesUncertainty) {
  LineModel model = webcam_model();
  const Matrix3 exact = fit_of(model, pair_at(model, kPoint, 1)).pose->noise.topLeftCorner<3, 3>();
  model.target.points[0].uncertainty_mm = 0.2;  // k = 2
  const Matrix3 mounted = fit_of(model, pair_at(model, kPoint, 1)).pose->noise.topLeftCorner<3, 3>();
  EXPECT_TRUE((mounted - exact).isApprox(0.01 * Matrix3::Identity(), 1e-9));
}

class PoseByMethodTest : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, PoseByMethodTest, ::testing::Values(Method::kMaximumLikelihood, Method::kPaper),
                         [](const auto& each) { return each.param == Method::kPaper ? "Paper" : "Likelihood"; });

class PoseInFrameTest : public ::testing::TestWithParam<std::tuple<Method, OutputFrame>> {};
INSTANTIATE_TEST_SUITE_P(Frames, PoseInFrameTest,
                         ::testing::Combine(::testing::Values(Method::kMaximumLikelihood, Method::kPaper),
                                            ::testing::Values(OutputFrame::kReference, OutputFrame::kLeftCamera)));

TEST_P(PoseInFrameTest, ACalibrationErrorMovesThePoseAsItsCovarianceSays) {
  const auto [method, frame] = GetParam();
  // left fx, left cy, left k1, right cx, right cy, turns about x, y and z, baseline and across it
  for (const int parameter : {0, 3, 4, 11, 12, 18, 19, 20, 21, 22}) {
    LineModel model = webcam_model();
    model.method = method;
    give_poses_in(frame, model);
    const double step = parameter == 4 || (parameter >= 18 && parameter <= 20) ? 1e-4 : 0.05;
    model.covariance(parameter, parameter) = step * step;
    const Fit fit = fit_of(model, pair_at(model, kPoint, 1));
    // the truth: the same pixels through a calibration that is off by that much
    RigParameters wrong = parameters_of(model.calibration);
    wrong[parameter] += step;
    LineModel off = model;
    off.calibration = calibration_of(wrong, {{640, 480}, {640, 480}});
    off.rig = *rig_of(off.calibration);
    give_poses_in(frame, off);
    const Vec3 in_output_mm = model.output_from_rig * kPoint;
    const Vec3 moved = fit_of(off, pair_at(model, kPoint, 1)).pose->position_in_output_mm - in_output_mm;
    const Matrix3 expected = moved * moved.transpose();
    const Matrix3 error = fit.pose->shared.topLeftCorner<3, 3>() - expected;
    EXPECT_LT(error.norm(), 0.01 * expected.norm() + 1e-4 * step * step) << parameter;  // second order
    const Matrix3 whole = (fit.pose->shared + fit.pose->noise).topLeftCorner<3, 3>();
    EXPECT_TRUE(fit.points[0].covariance_mm2.isApprox(whole, 1e-12));
  }
}

TEST_P(PoseByMethodTest, AnErrorOfTheClocksMovesThePoseAsItIsSaid) {
  LineModel model = webcam_model();
  model.method = GetParam();
  constexpr double kOffset_s = 0.005;  // as much as the skew
  const Vec2 velocity_px_per_s{150.0, 40.0};
  Pair pair = pair_at(model, kPoint, 1);
  for (const Side side : kBothSides) pair.points[side].velocity_px_per_s = velocity_px_per_s;
  pair.points.right.timing_px2 = kOffset_s * kOffset_s * velocity_px_per_s * velocity_px_per_s.transpose();
  const Fit fit = fit_of(model, pair, kOffset_s);
  Pair late = pair;
  late.points.right.seen.at.u_px += kOffset_s * velocity_px_per_s.x();
  late.points.right.seen.at.v_px += kOffset_s * velocity_px_per_s.y();
  const double moved_mm = (fit_of(model, late).pose->position_in_output_mm - kPoint).norm();
  EXPECT_NEAR(fit.timing_sigma_mm, moved_mm, 0.02 * moved_mm);
  EXPECT_NEAR(fit.uncorrected_cost_mm.value(), moved_mm, 0.02 * moved_mm);
}

TEST(PoseTest, AnUnidentifiedPairIsAPointAndNoPose) {
  const LineModel model = webcam_model();
  const Fit fit = fit_of(model, pair_at(model, kPoint, 0));
  EXPECT_FALSE(fit.pose);
  EXPECT_EQ(fit.points.size(), 1U);
}

TEST(PoseTest, RaysThatDoNotMeetAreAFaultOfGeometry) {
  const LineModel model = webcam_model();
  Pair pair = pair_at(model, kPoint, 1);
  std::swap(pair.points.left.seen.at, pair.points.right.seen.at);
  pair.points.left.seen.at.u_px -= 300.0;
  pair.points.right.seen.at.u_px += 300.0;
  const Fit fit = fit_of(model, pair);
  EXPECT_EQ(fit.faults, Faults{Fault::kGeometryGate});
  EXPECT_FALSE(fit.pose);
}

TEST(PoseTest, TheGainIsHowAPixelMovesThePoint) {
  const LineModel model = webcam_model();
  PerSide<MeasuredPixel> seen;
  const PerSide<RawPixel> at = pixels_of(model, kPoint);
  for (const Side side : kBothSides) seen[side] = {at[side], 0.0025 * Matrix2::Identity()};
  const TriangulatedPoint point = *triangulated(model.rig, seen);
  constexpr double kStep_px = 1e-3;
  for (const Side side : kBothSides) {
    const Matrix32 gain = pixel_gain_mm_per_px(model.rig, point, seen, side);
    PerSide<MeasuredPixel> moved = seen;
    moved[side].at.u_px += kStep_px;
    EXPECT_LT(((triangulated(model.rig, moved)->in_rig_mm - point.in_rig_mm) / kStep_px - gain.col(0)).norm(), 1e-3);
    moved = seen;
    moved[side].at.v_px += kStep_px;
    EXPECT_LT(((triangulated(model.rig, moved)->in_rig_mm - point.in_rig_mm) / kStep_px - gain.col(1)).norm(), 1e-3);
  }
}

TEST(PoseTest, TimeCostsDepthTimesSpeedOverBaseline) {
  // parallel cameras: along the baseline at 100 mm/s an offset of 5 ms costs (Z/B) v dt = 4 * 0.5 mm = 2 mm in depth
  LineModel model = webcam_model();
  model.calibration.cameras.left = model.calibration.cameras.right =
      CameraModel{{640, 480}, {628, 628}, {320, 240}, {}};
  model.calibration.right_from_left = Eigen::Translation3d(-100.0, 0.0, 0.0);
  model.rig = *rig_of(model.calibration);
  Pair pair = pair_at(model, {0.0, 0.0, 400.0}, 1);
  const Vec2 velocity_px_per_s{628.0 * 100.0 / 400.0, 0.0};
  for (const Side side : kBothSides) pair.points[side].velocity_px_per_s = velocity_px_per_s;
  pair.points.right.timing_px2 = 0.005 * 0.005 * velocity_px_per_s * velocity_px_per_s.transpose();
  const Fit fit = fit_of(model, pair, 0.005);
  const double expected_mm = std::hypot(4.0 * 0.5, 0.5 / 2.0);  // depth, and half the shift sideways
  EXPECT_NEAR(fit.timing_sigma_mm, expected_mm, 1e-6);
  EXPECT_NEAR(fit.uncorrected_cost_mm.value(), expected_mm, 1e-6);
  EXPECT_GT(fit.pose->noise(2, 2), 4.0) << "it is part of the stated covariance";
}

TEST(PoseTest, WhatTheSkewCostsIsUnknownWithoutASpeed) {
  const LineModel model = webcam_model();
  EXPECT_FALSE(fit_of(model, pair_at(model, {0.0, 0.0, 400.0}, 1), 0.005).uncorrected_cost_mm);
}

TEST(PoseTest, WhatTheSkewCostsIsUnknownWithoutATarget) {
  const LineModel model = webcam_model();
  Pair pair = pair_at(model, {0.0, 0.0, 400.0}, 0);
  for (const Side side : kBothSides) pair.points[side].velocity_px_per_s = Vec2(150.0, 0.0);
  EXPECT_FALSE(fit_of(model, pair, 0.005).uncorrected_cost_mm);
  pair.id = 1;
  EXPECT_TRUE(fit_of(model, pair, 0.005).uncorrected_cost_mm);
}

}  // namespace
}  // namespace tripoint
