#include "line/pose/body_pose.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "../../geometry/random.h"
#include "../synthetic_cameras.h"
#include "geometry/rigid_fit.h"
#include "line/pose/output_frame.h"
#include "line/pose/pose.h"
#include "line/pose/timing_part.h"

namespace tripoint {
namespace {

using testing::Noise;
using testing::relative_difference;
using testing::Spread;

const std::vector<Vec3> kTriangle{{-20.0, 12.0, 0.0}, {80.0, 12.0, 0.0}, {-2.0, -36.0, 0.0}};
constexpr double kSigma_px = 0.1;

Isometry3 pose_at(const Vec3& place_mm) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = (Eigen::AngleAxisd(2.7, Vec3::UnitX()) * Eigen::AngleAxisd(0.4, Vec3::UnitY())).toRotationMatrix();
  pose.translation() = place_mm;
  return pose;
}
const Isometry3 kPose = pose_at({20.0, -15.0, 420.0});

LineModel model_by(Method method, const std::vector<Vec3>& leds_mm = kTriangle) {
  LineModel model = testing::webcam_model();
  model.method = method;
  model.target.points.clear();
  for (std::size_t i = 0; i < leds_mm.size(); ++i) {
    model.target.points.push_back({static_cast<int>(i) + 1, leds_mm[i], 0.0});
  }
  return model;
}

Pairs pairs_of(const LineModel& model, const Isometry3& rig_from_target) {
  Pairs pairs;
  for (const TargetPoint& point : model.target.points) {
    Pair pair;
    pair.id = point.id;
    for (const Side side : kBothSides) {
      const auto path = testing::at_rest(rig_from_target * point.in_target_mm);
      pair.points[side].seen = testing::spot_at(testing::pixel_of(model, side, path, 0.0, 0.0), kSigma_px);
    }
    pairs.pairs.push_back(pair);
  }
  return pairs;
}

Fit fit_of(const LineModel& model, const Pairs& pairs) {
  Aligned seen;
  seen.common_time = true;
  seen.skew_s = 0.005;
  return pose_of_target(seen, pairs, model);
}

Pairs blurred(Pairs pairs, Noise& noise) {
  for (Pair& pair : pairs.pairs) {
    for (const Side side : kBothSides) {
      pair.points[side].seen.at.u_px += kSigma_px * noise.normal();
      pair.points[side].seen.at.v_px += kSigma_px * noise.normal();
    }
  }
  return pairs;
}

PoseParameters difference(const Isometry3& from, const TargetPose& to) {
  const Eigen::AngleAxisd turn(to.output_from_target.value() * from.linear().transpose());
  PoseParameters step;
  step << to.position_in_output_mm - from.translation(), turn.angle() * turn.axis();
  return step;
}

class BodyPoseTest : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, BodyPoseTest, ::testing::Values(Method::kMaximumLikelihood, Method::kPaper),
                         [](const auto& each) { return each.param == Method::kPaper ? "Paper" : "Likelihood"; });

TEST_P(BodyPoseTest, ExactPicturesGiveTheExactPoseInTheOutputFrame) {
  LineModel model = model_by(GetParam());
  model.output_from_rig = Eigen::Translation3d(100.0, 200.0, 300.0) * Eigen::AngleAxisd(0.5, Vec3::UnitY());
  const Fit fit = fit_of(model, pairs_of(model, kPose));
  ASSERT_TRUE(fit.pose);
  EXPECT_LT(difference(model.output_from_rig * kPose, *fit.pose).norm(), 1e-6);
  EXPECT_EQ(fit.points.size(), 3U);
}

TEST_P(BodyPoseTest, NoisyPicturesScatterThePoseAsItsCovarianceSays) {
  LineModel model = model_by(GetParam());
  model.output_from_rig = Isometry3(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  const Pairs exact = pairs_of(model, kPose);
  Noise noise{31};
  Spread<6> spread;
  for (int run = 0; run < 10'000; ++run) {
    spread.add(difference(model.output_from_rig * kPose, fit_of(model, blurred(exact, noise)).pose.value()));
  }
  EXPECT_LT(relative_difference<6>(spread.covariance(), fit_of(model, exact).pose->noise), 0.08);
}

// In their order in the file the first three say nothing about a turn around the line they lie on.
TEST_P(BodyPoseTest, ItDoesNotMatterThatTheFirstThreeLieNearlyOnALine) {
  for (const double off_line_mm : {0.0, 0.2, 1.0}) {
    const LineModel model =
        model_by(GetParam(), {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {50.0, off_line_mm, 0.0}, {60.0, 50.0, 0.0}});
    const Pairs exact = pairs_of(model, kPose);
    Noise noise{5};
    for (int run = 0; run < 500; ++run) {
      const Fit fit = fit_of(model, blurred(exact, noise));
      ASSERT_TRUE(fit.pose);
      EXPECT_LT(difference(kPose, *fit.pose).tail<3>().norm(), 0.1);
    }
  }
}

TEST_P(BodyPoseTest, APointThatLiesElsewhereThanThePoseSaysIsRefused) {
  const LineModel model =
      model_by(GetParam(), {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {64.0, 48.0, 0.0}, {50.0, 20.0, 40.0}});
  LineModel elsewhere = model;
  elsewhere.target.points[3].in_target_mm.z() = -40.0;
  const Fit fit = fit_of(model, pairs_of(elsewhere, kPose));
  EXPECT_FALSE(fit.pose);
  EXPECT_EQ(fit.faults, Faults{Fault::kGeometryGate});
}

TEST_P(BodyPoseTest, TwoIdentifiedPointsAreNoPoseAndNoFault) {
  const LineModel model = model_by(GetParam(), {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}});
  const Fit fit = fit_of(model, pairs_of(model, kPose));
  EXPECT_FALSE(fit.pose);
  EXPECT_TRUE(fit.faults.empty());
  EXPECT_EQ(fit.points.size(), 2U);
}

class BodyPoseInFrameTest : public ::testing::TestWithParam<std::tuple<Method, OutputFrame>> {};
INSTANTIATE_TEST_SUITE_P(Frames, BodyPoseInFrameTest,
                         ::testing::Combine(::testing::Values(Method::kMaximumLikelihood, Method::kPaper),
                                            ::testing::Values(OutputFrame::kReference, OutputFrame::kLeftCamera)));

TEST_P(BodyPoseInFrameTest, ACalibrationErrorMovesThePoseAsItsCovarianceSays) {
  const auto [method, frame] = GetParam();
  // left fx, left cy, right cx, right k1, turns about x, y and z, baseline and across it
  for (const int parameter : {0, 3, 11, 13, 18, 19, 20, 21, 22}) {
    LineModel model = model_by(method);
    give_poses_in(frame, model);
    const double step = parameter == 13 || (parameter >= 18 && parameter <= 20) ? 1e-4 : 0.05;
    model.covariance(parameter, parameter) = step * step;
    RigParameters wrong = parameters_of(model.calibration);
    wrong[parameter] += step;
    LineModel off = model;
    off.calibration = calibration_of(wrong, {{640, 480}, {640, 480}});
    off.rig = *rig_of(off.calibration);
    give_poses_in(frame, off);
    const Pairs pairs = pairs_of(model, kPose);
    const PoseParameters moved = difference(model.output_from_rig * kPose, fit_of(off, pairs).pose.value());
    const Matrix6 stated = fit_of(model, pairs).pose->shared;
    const Matrix6 expected = moved * moved.transpose();
    for (const int corner : {0, 3}) {  // place, attitude
      const Matrix3 there = expected.block<3, 3>(corner, corner);
      const Matrix3 error = stated.block<3, 3>(corner, corner) - there;
      EXPECT_LT(error.norm(), 0.03 * there.norm() + 1e-4 * step * step) << "parameter " << parameter;
    }
  }
}

// The clocks err alike for all points: three of them know no better than one.
TEST_P(BodyPoseTest, AnErrorOfTheClocksMovesThePoseAsItIsSaid) {
  LineModel model = model_by(GetParam());
  Pairs pairs = pairs_of(model, kPose);
  constexpr double kOffset_s = 0.005;  // as much as the skew
  const std::vector<Vec2> velocities_px_per_s{{150.0, 20.0}, {170.0, 10.0}, {140.0, 35.0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& velocity = velocities_px_per_s[i];
    for (const Side side : kBothSides) pairs.pairs[i].points[side].velocity_px_per_s = velocity;
    pairs.pairs[i].points.right.timing_px2 = kOffset_s * kOffset_s * velocity * velocity.transpose();
  }
  const Fit fit = fit_of(model, pairs);
  Pairs late = pairs;
  for (std::size_t i = 0; i < 3; ++i) {
    RawPixel& at = late.pairs[i].points.right.seen.at;
    at = {at.u_px + kOffset_s * velocities_px_per_s[i].x(), at.v_px + kOffset_s * velocities_px_per_s[i].y()};
  }
  const double moved_mm = difference(kPose, fit_of(model, late).pose.value()).head<3>().norm();
  EXPECT_GT(moved_mm, 0.3);
  EXPECT_NEAR(fit.timing_sigma_mm, moved_mm, 0.03 * moved_mm);
  EXPECT_NEAR(fit.uncorrected_cost_mm.value(), moved_mm, 0.03 * moved_mm);
  const Vec3 variances_mm2 = fit.pose->noise.diagonal().head<3>();
  EXPECT_GT(variances_mm2.sum(), moved_mm * moved_mm) << "it is part of what is stated";
}

TEST_P(BodyPoseTest, WithoutAllPointsThereIsNoPose) {
  const LineModel model = model_by(GetParam());
  Pairs pairs = pairs_of(model, kPose);
  pairs.pairs.truncate(2);
  EXPECT_FALSE(fit_of(model, pairs).pose);
  pairs = pairs_of(model, kPose);
  pairs.pairs[1].id = 0;
  EXPECT_FALSE(fit_of(model, pairs).pose);
}

TEST(TimingRootTest, IsARootWithItsFirstColumnAlongTheVelocity) {
  Matrix2 timing;
  timing << 4.0, 1.0, 1.0, 2.0;
  for (const Vec2& velocity : {Vec2(3.0, 0.0), Vec2(-1.0, 2.0), Vec2(0.0, 0.0)}) {
    const Matrix2 root = timing_root_px(timing, velocity);
    EXPECT_LT((root * root.transpose() - timing).norm(), 1e-12);
  }
  const Vec2 velocity(-1.0, 2.0);
  const Matrix2 one_way = velocity * velocity.transpose();
  EXPECT_LT((timing_root_px(one_way, velocity).col(0) - velocity).norm(), 1e-12);
  EXPECT_LT((timing_root_px(one_way, Vec2(-velocity)).col(0) + velocity).norm(), 1e-12);
  EXPECT_EQ(timing_root_px(Matrix2::Zero(), velocity), Matrix2::Zero());
}

}  // namespace
}  // namespace tripoint
