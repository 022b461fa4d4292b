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

}  // namespace
}  // namespace tripoint
