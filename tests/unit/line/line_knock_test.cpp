// A camera is knocked, and put back, while the line follows three LEDs.
#include <numbers>

#include <gtest/gtest.h>

#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::exposed_s;
using testing::shot;
using testing::webcam_model;

constexpr double kKnocked_s = 5.0;
constexpr double kPutBack_s = 9.0;

LineModel model_of_three() {
  LineModel model = webcam_model();
  model.target.points[0].uncertainty_mm = 0.05;
  model.target.points.push_back({2, {80.0, 0.0, 0.0}, 0.05});
  model.target.points.push_back({3, {20.0, 50.0, 0.0}, 0.05});
  return model;
}

/// The target turned away from nobody: its z looks at the cameras.
std::vector<testing::Path> three_leds(double speed_mm_per_s) {
  std::vector<testing::Path> paths;
  for (const Vec3& led : {Vec3(0.0, 0.0, 0.0), Vec3(80.0, 0.0, 0.0), Vec3(20.0, -50.0, 0.0)}) {
    paths.push_back([=, path = testing::circle(speed_mm_per_s)](double time_s) -> Vec3 { return path(time_s) + led; });
  }
  return paths;
}

double time_s(const Event& event) { return seconds(std::get<Observation>(event).exposed.time_since_epoch()); }

/// Fourteen seconds of free-running cameras, of which the right one stands turned for four.
std::vector<Event> knocked_for_a_while(const LineModel& model, const Vec3& turn_rad, double speed_mm_per_s) {
  const LineModel knocked = testing::with_right_camera_turned(model, turn_rad);
  testing::Shooting shooting = testing::free_running();
  shooting.duration_s = 14.0;
  std::vector<Event> events = shot(model, three_leds(speed_mm_per_s), shooting);
  const std::vector<Event> meanwhile = shot(knocked, three_leds(speed_mm_per_s), shooting);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (time_s(events[i]) > kKnocked_s && time_s(events[i]) < kPutBack_s) events[i] = meanwhile[i];
  }
  return events;
}

TEST(LineKnockTest, AYawThatMovesNoPointOffItsEpipolarLineTakesThePoseUntilItIsPutBack) {
  const LineModel model = model_of_three();
  const Vec3 yaw_rad(0.0, 0.1 * std::numbers::pi / 180.0, 0.0);
  bool posed_before = false;
  bool posed_after = false;
  for (const Measurement& measurement : testing::verdicts(model, knocked_for_a_while(model, yaw_rad, 20.0))) {
    const double at_s = exposed_s(measurement);
    const bool alarm = measurement.faults.contains(Fault::kDecalibration);
    EXPECT_FALSE(alarm && measurement.pose);
    if (at_s < kKnocked_s) {
      EXPECT_FALSE(alarm) << at_s;
      posed_before = posed_before || measurement.pose;
    } else if (at_s > kKnocked_s + 2.0 && at_s < kPutBack_s) {
      EXPECT_TRUE(alarm) << at_s;
      EXPECT_GT(measurement.decalibration_mm.value_or(0.0), 0.5) << at_s;
    } else if (at_s > kPutBack_s + 4.0) {
      EXPECT_FALSE(alarm) << at_s;
      posed_after = posed_after || measurement.pose;
    }
  }
  EXPECT_TRUE(posed_before);
  EXPECT_TRUE(posed_after);
}

TEST(LineKnockTest, FastMotionBeforeClocksThatAreWrongAsStatedIsNoKnock) {
  const LineModel model = model_of_three();
  std::vector<Event> events = knocked_for_a_while(model, Vec3::Zero(), 300.0);
  for (Event& event : events) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == Side::kRight) seen.exposed += duration_from_seconds(2.0 * model.limits.offset_prior_s);
  }
  for (const Measurement& measurement : testing::verdicts(model, events)) {
    EXPECT_FALSE(measurement.faults.contains(Fault::kDecalibration)) << exposed_s(measurement);
  }
}

}  // namespace
}  // namespace tripoint
