#include "line/monitor/monitor.h"

#include <cmath>

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"

namespace tripoint {
namespace {

using testing::webcam_model;

Measurement measured(double time_s, const Vec3& position) {
  Measurement measurement;
  measurement.exposed = TimePoint{duration_from_seconds(time_s)};
  measurement.common_time = true;
  TargetPose pose;
  pose.position_in_output_mm = position;
  pose.noise.diagonal().head<3>().setConstant(0.01);
  measurement.pose = pose;
  return measurement;
}

Pairs pairs_with_residual(double residual_px) {
  Pairs pairs;
  Pair pair;
  pair.epipolar_px = residual_px;
  pairs.pairs.push_back(pair);
  return pairs;
}

TEST(MonitorTest, TheEpipolarRmsFollowsTheResiduals) {
  Monitor monitor;
  for (int i = 0; i < 400; ++i) monitor.learn(measured(i / 60.0, {0, 0, 400}), pairs_with_residual(i % 2 ? 0.3 : -0.1));
  // mean square of 0.3 and 0.1; an exponential mean over 32 swings by half the difference over 32
  EXPECT_NEAR(monitor.completed(Measurement{}, webcam_model()).epipolar_rms_px, std::sqrt(0.05), 0.003);
}

TEST(MonitorTest, ForecastsTheSpotInBothPictures) {
  Monitor monitor;
  LineModel model = webcam_model();
  model.output_from_rig = Eigen::Translation3d(7.0, 8.0, 9.0) * Eigen::AngleAxisd(0.3, Vec3::UnitZ());
  const auto position = [](double time_s) { return Vec3(100.0 * time_s, 20.0, 400.0); };
  for (int i = 0; i < 30; ++i) {
    monitor.learn(measured(i / 60.0, model.output_from_rig * position(i / 60.0)), {});
  }
  const Forecast forecast = monitor.forecast(duration_from_seconds(1.0 / 30.0), model);
  EXPECT_EQ(forecast.number, 30U);
  ASSERT_EQ(forecast.points.size(), 1U);
  EXPECT_EQ(forecast.points[0].id, 1);
  const Vec3 then = position(29.0 / 60.0 + 1.0 / 30.0);
  for (const Side side : kBothSides) {
    const RawPixel truth = testing::pixel_of(model, side, testing::at_rest(then), 0.0, 0.0);
    EXPECT_NEAR(forecast.points[0].at[side].u_px, truth.u_px, 1e-3);
    EXPECT_NEAR(forecast.points[0].at[side].v_px, truth.v_px, 1e-3);
    EXPECT_GT(forecast.points[0].covariance_px2[side].determinant(), 0.0);
  }
}

TEST(MonitorTest, ForecastsEveryPointOfATargetOnceItsRotationIsKnown) {
  LineModel model = webcam_model();
  const Vec3 arm_mm(0.0, 60.0, 10.0);
  model.target.points.push_back({.id = 2, .in_target_mm = arm_mm});
  const Matrix3 turned = Eigen::AngleAxisd(0.4, Vec3::UnitX()).toRotationMatrix();
  Monitor monitor;
  for (int i = 0; i < 30; ++i) monitor.learn(measured(i / 60.0, {0, 0, 400}), {});
  EXPECT_TRUE(monitor.forecast(Duration{0}, model).points.empty());  // where the second one is, nobody knows
  Measurement whole = measured(0.5, {0, 0, 400});
  whole.pose->output_from_target = turned;
  monitor.learn(whole, {});
  const Forecast forecast = monitor.forecast(duration_from_seconds(1.0 / 30.0), model);
  ASSERT_EQ(forecast.points.size(), 2U);
  EXPECT_EQ(forecast.points[1].id, 2);
  const Vec3 there = Vec3(0, 0, 400) + turned * arm_mm;
  for (const Side side : kBothSides) {
    const RawPixel truth = testing::pixel_of(model, side, testing::at_rest(there), 0.0, 0.0);
    EXPECT_NEAR(forecast.points[1].at[side].v_px, truth.v_px, 1e-3);
    // 1 rad/s for a frame turns the arm by 2 mm, 3 px.
    EXPECT_GT(forecast.points[1].covariance_px2[side](1, 1), forecast.points[0].covariance_px2[side](1, 1) + 4.0);
  }
}

TEST(MonitorTest, ForecastsNothingWhenAPointWouldBeBehindACamera) {
  LineModel model = webcam_model();
  model.target.points.push_back({.id = 2, .in_target_mm = {0.0, 0.0, -500.0}});
  Measurement whole = measured(0.5, {0, 0, 400});
  whole.pose->output_from_target = Matrix3::Identity();
  Monitor monitor;
  monitor.learn(whole, {});
  EXPECT_TRUE(monitor.forecast(Duration{0}, model).points.empty());
}

TEST(MonitorTest, ForecastsTheSpeedOfASpot) {
  Monitor monitor;
  const LineModel model = webcam_model();
  const auto position = [](double time_s) { return Vec3(100.0 * time_s, -60.0 * time_s, 400.0); };
  for (int i = 0; i < 30; ++i) monitor.learn(measured(i / 60.0, position(i / 60.0)), {});
  const Forecast forecast = monitor.forecast(Duration{0}, model);
  ASSERT_EQ(forecast.points.size(), 1U);
  constexpr double kStep_s = 1e-3;
  for (const Side side : kBothSides) {
    const RawPixel now = testing::pixel_of(model, side, testing::at_rest(position(29.0 / 60.0)), 0.0, 0.0);
    const RawPixel then = testing::pixel_of(model, side, testing::at_rest(position(29.0 / 60.0 + kStep_s)), 0.0, 0.0);
    EXPECT_NEAR(forecast.points[0].velocity_px_per_s[side].x(), (then.u_px - now.u_px) / kStep_s, 0.1);
    EXPECT_NEAR(forecast.points[0].velocity_px_per_s[side].y(), (then.v_px - now.v_px) / kStep_s, 0.1);
  }
}

TEST(MonitorTest, ForecastsNothingBeforeAPoseNorAfterTheMotionIsDropped) {
  Monitor monitor;
  const LineModel model = webcam_model();
  EXPECT_EQ(monitor.forecast(Duration{0}, model).number, 0U);
  EXPECT_TRUE(monitor.forecast(Duration{0}, model).points.empty());
  monitor.learn(measured(1.0, {0, 0, 400}), {});
  EXPECT_FALSE(monitor.forecast(Duration{0}, model).points.empty());
  monitor.forget_motion();
  EXPECT_TRUE(monitor.forecast(Duration{0}, model).points.empty());
}

TEST(MonitorTest, SpeedAndSettledBelongToMeasurementsWithAPose) {
  Monitor monitor;
  const LineModel model = webcam_model();
  for (int i = 0; i < 30; ++i) monitor.learn(measured(i / 60.0, {0, 0, 400}), {});
  EXPECT_TRUE(monitor.completed(measured(0.5, {0, 0, 400}), model).timing.settled);
  Measurement unseen;
  EXPECT_FALSE(monitor.completed(unseen, model).timing.settled);
}

TEST(MonitorTest, ADatumThatWasSeenLatelyIsForecastWhereItWasSeen) {
  Monitor monitor;
  LineModel model = webcam_model();
  model.datum = Datum{{-80.0, 95.0, 620.0}, 0.2, 10.0};
  const Duration ahead = duration_from_seconds(1.0 / 30.0);
  Pairs with_datum;
  with_datum.datum.emplace();
  with_datum.datum->points.left.seen.at = {120.0, 80.0};
  with_datum.datum->points.right.seen.at = {90.0, 85.0};
  for (int i = 0; i < 30; ++i) monitor.learn(measured(i / 60.0, {0.0, 0.0, 400.0}), with_datum);
  const Forecast forecast = monitor.forecast(ahead, model);
  ASSERT_EQ(forecast.points.size(), 2U);
  EXPECT_EQ(forecast.points[1].id, 0);
  EXPECT_EQ(forecast.points[1].at.left.u_px, 120.0);
  EXPECT_EQ(forecast.points[1].at.right.v_px, 85.0);
  EXPECT_EQ(forecast.points[1].velocity_px_per_s.left, Vec2(0.0, 0.0));
  for (int i = 30; i < 59; ++i) monitor.learn(measured(i / 60.0, {0.0, 0.0, 400.0}), {});
  EXPECT_EQ(monitor.forecast(ahead, model).points.size(), 2U);
  for (int i = 59; i < 65; ++i) monitor.learn(measured(i / 60.0, {0.0, 0.0, 400.0}), {});
  EXPECT_EQ(monitor.forecast(ahead, model).points.size(), 1U);
}

}  // namespace
}  // namespace tripoint
