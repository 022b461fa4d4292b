#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::at_rest;
using testing::Path;
using testing::shared_model;
using testing::Shooting;
using testing::shot;
using testing::verdicts;
using testing::webcam_model;

const Vec3 kMiddle{10.0, 15.0, 400.0};

Shooting short_and_simultaneous() {
  Shooting shooting;
  shooting.duration_s = 0.5;
  return shooting;
}

std::vector<Event> pictures(const std::vector<Path>& paths = {at_rest(kMiddle)}) {
  return shot(webcam_model(), paths, short_and_simultaneous());
}

void change(std::vector<Event>& events, Side side, const std::function<void(Observation&)>& how) {
  for (Event& event : events) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == side) how(seen);
  }
}

/// The last verdict, which must exist.
Measurement last(const LineModel& model, const std::vector<Event>& events) {
  const auto found = verdicts(model, events);
  EXPECT_FALSE(found.empty());
  return found.empty() ? Measurement{} : found.back();
}

void expect_only(const Measurement& measurement, Fault fault) {
  EXPECT_EQ(measurement.faults.bits(), Faults{fault}.bits()) << kFaultNames[static_cast<std::size_t>(fault)];
  EXPECT_FALSE(measurement.pose);
  EXPECT_TRUE(measurement.common_time);
  EXPECT_GT(measurement.exposed, TimePoint{});
}

TEST(LineFaultsTest, WithoutOneThereIsAPose) {
  const Measurement measurement = last(webcam_model(), pictures());
  EXPECT_TRUE(measurement.faults.empty());
  ASSERT_TRUE(measurement.pose);
  EXPECT_EQ(measurement.points.size(), 1U);
  EXPECT_EQ(measurement.points[0].id, 1);
  EXPECT_EQ(measurement.spots.left, 1);
}

TEST(LineFaultsTest, WithoutAModelThereIsNoCalibration) {
  Line line(nullptr);
  const auto found = verdicts(line, pictures());
  ASSERT_FALSE(found.empty());
  expect_only(found.back(), Fault::kNoCalibration);
  EXPECT_EQ(found.back().spots.left, 1) << "what needs no calibration is published anyhow";
}

TEST(LineFaultsTest, ACalibrationOfOtherCamerasIsRefused) {
  LineModel model = webcam_model();
  model.calibration_fits = false;
  const Measurement measurement = last(model, pictures());
  expect_only(measurement, Fault::kCalibrationDoesNotFit);
  EXPECT_TRUE(measurement.points.empty());
}

TEST(LineFaultsTest, ASpotMissingOnOneSideIsNamed) {
  for (const Side side : kBothSides) {
    auto events = pictures();
    change(events, side, [](Observation& seen) { seen.points.clear(); });
    expect_only(last(webcam_model(), events), side == Side::kLeft ? Fault::kNotSeenLeft : Fault::kNotSeenRight);
  }
}

TEST(LineFaultsTest, ATwinOnTheSameEpipolarLineIsAmbiguous) {
  // along the line through the left camera's centre, so that the left picture shows one spot and the right two
  const LineModel model = webcam_model();
  const Vec3 eye = model.rig.camera_from_rig.left.inverse().translation();
  auto events = pictures({at_rest(kMiddle), at_rest(eye + 1.1 * (kMiddle - eye))});
  change(events, Side::kLeft, [](Observation& seen) { seen.points.truncate(1); });
  const Measurement measurement = last(model, events);
  expect_only(measurement, Fault::kAmbiguous);
  EXPECT_TRUE(measurement.points.empty());
}

TEST(LineFaultsTest, TwoPossiblePairsForOneLightAreAmbiguousAndPublishedUnidentified) {
  const Measurement measurement = last(webcam_model(), pictures({at_rest(kMiddle), at_rest({-20.0, -40.0, 380.0})}));
  expect_only(measurement, Fault::kAmbiguous);
  ASSERT_EQ(measurement.points.size(), 2U);
  for (const MeasuredPoint& point : measurement.points) EXPECT_EQ(point.id, 0);
}

/// Sides of 80, 78.1 and 53.9 mm; it faces the cameras when turned about x by half a turn.
LineModel model_of_triangle() {
  LineModel model = webcam_model();
  model.target.points.push_back(TargetPoint{2, {80.0, 0.0, 0.0}, 0.05});
  model.target.points.push_back(TargetPoint{3, {20.0, 50.0, 0.0}, 0.05});
  return model;
}

TEST(LineFaultsTest, ATriangleIsIdentifiedAndGivesAFullPose) {
  const auto events = pictures({at_rest({80, 0, 400}), at_rest({20, -50, 400}), at_rest({0, 0, 400})});
  const Measurement measurement = last(model_of_triangle(), events);
  EXPECT_TRUE(measurement.faults.empty());
  ASSERT_EQ(measurement.points.size(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(measurement.points[static_cast<std::size_t>(i)].id, i + 1);
  ASSERT_TRUE(measurement.pose && measurement.pose->output_from_target);
  EXPECT_LT(measurement.pose->position_in_output_mm.head<2>().norm(), 0.3);
  EXPECT_NEAR(measurement.pose->position_in_output_mm.z(), 400.0, 1.5);
  const Matrix3 half_turn = Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix();
  EXPECT_LT((*measurement.pose->output_from_target - half_turn).norm(), 0.02);
}

TEST(LineFaultsTest, ATriangleThatShinesAwayIsAnImageInAMirror) {
  const auto events = pictures({at_rest({80, 0, 400}), at_rest({20, 50, 400}), at_rest({0, 0, 400})});
  const Measurement measurement = last(model_of_triangle(), events);
  expect_only(measurement, Fault::kGeometryGate);
  EXPECT_EQ(measurement.points.size(), 3U);
}

TEST(LineFaultsTest, OfATriangleSeenInPartThePointsAreSaidAndNoPose) {
  const auto events = pictures({at_rest({80, 0, 400}), at_rest({0, 0, 400})});
  const Measurement measurement = last(model_of_triangle(), events);
  EXPECT_EQ(measurement.faults, (Faults{Fault::kNotSeenLeft, Fault::kNotSeenRight}));
  EXPECT_FALSE(measurement.pose);
  ASSERT_EQ(measurement.points.size(), 2U);
  for (const MeasuredPoint& point : measurement.points) EXPECT_EQ(point.id, 0);
}

TEST(LineFaultsTest, LightsThatDoNotLieAsTheTargetsDoAreNotTheTarget) {
  const auto events = pictures({at_rest({90, 0, 400}), at_rest({20, -50, 400}), at_rest({0, 0, 400})});
  expect_only(last(model_of_triangle(), events), Fault::kGeometryGate);
}

TEST(LineFaultsTest, TwoTargetsAreAmbiguous) {
  const auto events = pictures({at_rest({80, 0, 400}), at_rest({20, -50, 400}), at_rest({0, 0, 400}),
                                at_rest({80, 63, 410}), at_rest({20, 13, 410}), at_rest({0, 63, 410})});
  EXPECT_TRUE(last(model_of_triangle(), events).faults.contains(Fault::kAmbiguous));
}

TEST(LineFaultsTest, MoreSpotsThanCanBeMatchedAreAmbiguous) {
  std::vector<Path> many;
  for (int i = 0; i < 13; ++i) many.push_back(at_rest({-90.0 + 15.0 * i, -80.0 + 13.0 * i, 400.0}));
  expect_only(last(webcam_model(), pictures(many)), Fault::kAmbiguous);
}

TEST(LineFaultsTest, SpotsThatWereNotLookedAtAreAmbiguous) {
  auto events = pictures();
  change(events, Side::kRight, [](Observation& seen) { seen.health.candidates_cut = true; });
  expect_only(last(webcam_model(), events), Fault::kAmbiguous);
}

TEST(LineFaultsTest, SpotsOffEachOthersEpipolarLineFailTheGate) {
  auto events = pictures();
  // 4.5 sigma: of a difference of two places of 0.05 px that is 0.32 px
  change(events, Side::kRight, [](Observation& seen) { seen.points[0].at.v_px += 0.8; });
  expect_only(last(webcam_model(), events), Fault::kEpipolarGate);
}

TEST(LineFaultsTest, ACalibrationsUncertaintyWidensTheGate) {
  auto events = pictures();
  change(events, Side::kRight, [](Observation& seen) { seen.points[0].at.v_px += 0.8; });
  LineModel model = webcam_model();
  model.covariance(12, 12) = 0.5 * 0.5;  // centre of the right picture, v, px
  EXPECT_TRUE(last(model, events).pose);
}

TEST(LineFaultsTest, RaysThatMeetBehindTheCamerasFailTheGeometryGate) {
  // swapped: what the left camera shows is given out as the right one's and the other way round
  LineModel model = webcam_model();
  model.volume.reset();
  model.calibration.cameras.left = model.calibration.cameras.right =
      CameraModel{{640, 480}, {628, 628}, {320, 240}, {}};
  model.calibration.right_from_left = Eigen::Translation3d(-100.0, 0.0, 0.0);
  model.rig = *rig_of(model.calibration);
  auto events = shot(model, {at_rest(kMiddle)}, short_and_simultaneous());
  for (Event& event : events) std::get<Observation>(event).side = other(std::get<Observation>(event).side);
  expect_only(last(model, events), Fault::kGeometryGate);
}

TEST(LineFaultsTest, APointOutsideTheVolumeIsRefusedSidewaysAndInDepth) {
  for (const Vec3& where : {Vec3{60.0, 0.0, 400.0}, Vec3{0.0, 0.0, 480.0}}) {
    LineModel model = webcam_model();
    model.volume = WorkingVolume{{-50.0, -50.0, 350.0}, {50.0, 50.0, 450.0}};
    expect_only(last(model, pictures({at_rest(where)})), Fault::kOutsideVolume);
  }
}

TEST(LineFaultsTest, PicturesTooFarApartAreNotJoined) {
  Shooting shooting;
  shooting.duration_s = 2.0;
  shooting.timing.left = {0.090, 0.0, 0.0, 0.0, 0.010};
  shooting.timing.right = {0.090, 0.045, 0.0, 0.0, 0.010};
  const LineModel model = webcam_model();
  expect_only(last(model, shot(model, {at_rest(kMiddle)}, shooting)), Fault::kTimingBound);
}

TEST(LineFaultsTest, ANumberThatIsNoneIsInternalAndDoesNotComeOut) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(Observation&)>> poisons{
      [](Observation& seen) { seen.points[0].at.u_px = kNone; },
      [](Observation& seen) { seen.points[0].at.v_px = std::numeric_limits<double>::infinity(); },
      [](Observation& seen) { seen.points[0].covariance_px2(0, 1) = kNone; },
      [](Observation& seen) { seen.health.mean_luma = kNone; }};
  for (const auto& poison : poisons) {
    auto events = pictures();
    change(events, Side::kLeft, poison);
    const Measurement measurement = last(webcam_model(), events);
    EXPECT_TRUE(measurement.faults.contains(Fault::kInternal));
    EXPECT_FALSE(measurement.pose);
    EXPECT_TRUE(std::isfinite(measurement.health.left.mean_luma + measurement.residual_rms_px));
    for (const MeasuredPoint& point : measurement.points) EXPECT_TRUE(point.in_output_mm.allFinite());
  }
}

TEST(LineFaultsTest, AModelOfNonsenseGivesNoPose) {
  LineModel model = webcam_model();
  model.output_from_rig.translation().x() = std::numeric_limits<double>::quiet_NaN();
  model.volume.reset();
  const Measurement measurement = last(model, pictures());
  EXPECT_TRUE(measurement.faults.contains(Fault::kInternal));
  EXPECT_FALSE(measurement.pose);
  EXPECT_TRUE(measurement.points.empty());
}

TEST(LineFaultsTest, AWarningIsThatOfThisVeryMeasurement) {  // registers hold it for ten seconds, not the line
  Shooting shooting;
  shooting.duration_s = 4.0;
  const LineModel model = webcam_model();
  auto events = shot(model, {at_rest(kMiddle)}, shooting);
  std::get<Observation>(events[60]).points[0].saturated = true;  // both exposed 1 s after the first
  std::get<Observation>(events[61]).points[0].saturated = true;
  for (const Measurement& measurement : verdicts(model, events)) {
    const double since_s = testing::exposed_s(measurement) - 2.0;
    EXPECT_EQ(measurement.warnings.contains(Warning::kSaturatedSpot), std::abs(since_s) < 0.001) << since_s;
  }
}

}  // namespace
}  // namespace tripoint
