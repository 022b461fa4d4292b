#include "app/unit_report.h"

#include <gtest/gtest.h>

#include <vector>

#include "line/detect/exposure_margin.h"
#include "serve/reading.h"

namespace tripoint {
namespace {

class HeldClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  [[nodiscard]] Duration utc_offset() const override { return std::chrono::hours(1); }
  [[nodiscard]] bool synchronised() const override { return true; }
  void set(TimePoint now) { now_ = now; }

 private:
  TimePoint now_ = time_from_ns(1'000'000'000);
};

UnitConstants calibrated_unit() {
  UnitConstants constants;
  constants.calibrated = true;
  constants.simulated = false;
  return constants;
}

CameraStatus delivering() {
  CameraStatus camera;
  camera.delivering = true;
  return camera;
}

CameraStatus lost() {
  CameraStatus camera;
  camera.losses = 1;
  return camera;
}

Measurement with_pose() {
  Measurement measurement;
  measurement.common_time = true;
  measurement.pose = TargetPose{};
  return measurement;
}

TEST(UnitReportTest, IsReadyOnlyWithACalibrationAndBothCameras) {
  const HeldClock clock;
  const UnitReport calibrated(calibrated_unit(), clock.now());
  EXPECT_TRUE(calibrated.state({delivering(), delivering()}, clock).flags.ready);
  EXPECT_FALSE(calibrated.state({delivering(), lost()}, clock).flags.ready);
  const UnitReport uncalibrated(UnitConstants{}, clock.now());
  EXPECT_FALSE(uncalibrated.state({delivering(), delivering()}, clock).flags.ready);
}

TEST(UnitReportTest, ACameraWithoutGainHasNoNumberForIt) {
  const HeldClock clock;
  const UnitReport report(calibrated_unit(), clock.now());
  CameraStatus with_gain = delivering();
  with_gain.info.gain = 16;
  const UnitState state = report.state({with_gain, delivering()}, clock);
  EXPECT_EQ(state.cameras.left.gain, 16.0);
  EXPECT_EQ(state.cameras.right.gain, std::nullopt);
}

TEST(UnitReportTest, NamesTheCameraThatIsLost) {
  const HeldClock clock;
  const UnitReport report(calibrated_unit(), clock.now());
  const UnitState state = report.state({delivering(), lost()}, clock);
  EXPECT_EQ(state.faults, Faults{Fault::kRightCameraLost});
  EXPECT_EQ(state.state, registers::State::kCameraFault);
}

TEST(UnitReportTest, ACameraNotYetTriedIsStartingAndNotLost) {
  const HeldClock clock;
  const UnitReport report(calibrated_unit(), clock.now());
  const UnitState state = report.state({CameraStatus{}, CameraStatus{}}, clock);
  EXPECT_TRUE(state.faults.empty());
  EXPECT_EQ(state.state, registers::State::kStarting);
  EXPECT_EQ(state.cameras.left.state, registers::CameraState::kStarting);
}

TEST(UnitReportTest, WithoutACalibrationSaysSo) {
  const HeldClock clock;
  const UnitReport report(UnitConstants{}, clock.now());
  const UnitState state = report.state({delivering(), delivering()}, clock);
  EXPECT_EQ(state.state, registers::State::kNoCalibration);
  EXPECT_TRUE(state.faults.contains(Fault::kNoCalibration));
}

TEST(UnitReportTest, TheHeartBeatsForCommonTimesOnly) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  report.take(with_pose(), std::nullopt, clock);
  Measurement camera_change;
  report.take(camera_change, std::nullopt, clock);
  EXPECT_EQ(report.state({delivering(), delivering()}, clock).heartbeat, 1);
}

TEST(UnitReportTest, TheLossOfACameraIsNoExposure) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  report.take(Measurement{}, std::nullopt, clock);
  EXPECT_FALSE(report.state({lost(), lost()}, clock).exposure_since_start);
  report.take(with_pose(), std::nullopt, clock);
  report.take(Measurement{}, std::nullopt, clock);
  EXPECT_TRUE(report.state({lost(), lost()}, clock).exposure_since_start);
}

TEST(UnitReportTest, AVerdictWithoutAPoseIsSearching) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  report.take(with_pose(), std::nullopt, clock);
  EXPECT_EQ(report.state({delivering(), delivering()}, clock).state, registers::State::kMeasuring);
  Measurement empty;
  empty.common_time = true;
  report.take(empty, std::nullopt, clock);
  const UnitState state = report.state({delivering(), delivering()}, clock);
  EXPECT_EQ(state.state, registers::State::kSearching);
  EXPECT_TRUE(state.pose_since_start);
}

TEST(UnitReportTest, AStoppedUnitSaysSoAndIsNotReady) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  report.take(with_pose(), std::nullopt, clock);
  report.stop();
  const UnitState state = report.state({delivering(), delivering()}, clock);
  EXPECT_EQ(state.state, registers::State::kStopped);
  EXPECT_FALSE(state.flags.ready);
}

TEST(UnitReportTest, AWithdrawnPoseIsGoneWithItsCauseAndWhatElseFollowedFromTheCalibration) {
  using registers::StatusBit;
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  Measurement measurement = with_pose();
  measurement.exposed = clock.now();
  measurement.points.push_back(MeasuredPoint{});
  measurement.points[0].id = 1;
  measurement.timing.settled = true;
  measurement.mount_watched = true;
  report.take(measurement, std::nullopt, clock);
  const auto told = [&] { return live_reading(report.state({delivering(), delivering()}, clock), {}, clock.now()); };
  const std::vector<StatusBit> followed{StatusBit::kTracking, StatusBit::kPositionValid, StatusBit::kSettled,
                                        StatusBit::kMountWatched};
  for (const StatusBit bit : followed) EXPECT_TRUE(told().has(bit)) << static_cast<int>(bit);
  report.withdraw_pose(Fault::kCalibrationDoesNotFit);
  for (const StatusBit bit : followed) EXPECT_FALSE(told().has(bit)) << static_cast<int>(bit);
  EXPECT_EQ(told().faults, Faults{Fault::kCalibrationDoesNotFit}.bits());
  EXPECT_EQ(told().points_used, 0);
}

TEST(UnitReportTest, LatencyRunsFromTheArrivalOfThePicture) {
  HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  const TimePoint arrived = clock.now();
  clock.set(arrived + std::chrono::microseconds(250));
  report.take(with_pose(), arrived, clock);
  EXPECT_EQ(report.state({delivering(), delivering()}, clock).health.latency_p50_us, 250.0);
}

/// Lumas of the LED just clipping red (1), and of 3 and 10 times that; a lamp beside the target is brighter.
Measurement with_spots() {
  Measurement measurement;
  measurement.spots = {2, 2};
  for (const Side side : kBothSides) {
    measurement.health[side].dimmest_luma = luma_from_led_peak(1.0);
    measurement.health[side].peak_luma = luma_from_led_peak(10.0);
  }
  return measurement;
}

MeasuredPoint point(int id, double left_peak, double right_peak) {
  MeasuredPoint point;
  point.id = id;
  point.peak_luma = {luma_from_led_peak(left_peak), luma_from_led_peak(right_peak)};
  return point;
}

TEST(UnitReportTest, TheMarginOfTheExposureIsThatOfTheTargetsPoints) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  Measurement measurement = with_spots();
  measurement.points.push_back(point(1, 1.0, 3.0));
  measurement.points.push_back(point(2, 2.0, 6.0));
  report.take(measurement, std::nullopt, clock);
  const UnitState state = report.state({delivering(), delivering()}, clock);
  EXPECT_NEAR(state.cameras.left.above_dim.value(), 1.0 / 0.5, 1e-9);
  EXPECT_NEAR(state.cameras.left.below_clipping.value(), 30.0 / 2.0, 1e-9);
  EXPECT_NEAR(state.cameras.right.above_dim.value(), 3.0 / 0.5, 1e-9);
  EXPECT_NEAR(state.cameras.right.below_clipping.value(), 30.0 / 6.0, 1e-9);
}

TEST(UnitReportTest, WithoutATargetTheMarginIsThatOfEverySpotAndWithoutSpotsUnknown) {
  const HeldClock clock;
  UnitReport report(calibrated_unit(), clock.now());
  Measurement measurement = with_spots();
  measurement.points.push_back(point(0, 2.0, 2.0));
  report.take(measurement, std::nullopt, clock);
  const CameraStats seen = report.state({delivering(), delivering()}, clock).cameras.left;
  EXPECT_NEAR(seen.above_dim.value(), 1.0 / 0.5, 1e-9);
  EXPECT_NEAR(seen.below_clipping.value(), 3.0, 1e-9);
  EXPECT_FALSE(report.state({lost(), delivering()}, clock).cameras.left.above_dim);
  report.take(Measurement{}, std::nullopt, clock);
  EXPECT_FALSE(report.state({delivering(), delivering()}, clock).cameras.left.above_dim);
}

TEST(UnitReportTest, WhatIsSoBySetupIsWarnedAboutFromTheStart) {
  const HeldClock clock;
  UnitConstants constants = calibrated_unit();
  EXPECT_TRUE(UnitReport(constants, clock.now()).state({}, clock).warnings.empty());
  constants.warnings = {Warning::kNoUniqueSerial, Warning::kLightUnproved};
  EXPECT_EQ(UnitReport(constants, clock.now()).state({}, clock).warnings, constants.warnings);
}

}  // namespace
}  // namespace tripoint
