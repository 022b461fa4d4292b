// Cameras that come, go, hang and fall silent, and models that change.
#include <chrono>
#include <vector>

#include <gtest/gtest.h>

#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::at_rest;
using testing::shared_model;
using testing::Shooting;
using testing::shot;
using testing::webcam_model;

const Vec3 kMiddle{10.0, 15.0, 400.0};

TimePoint at(double time_s) { return TimePoint{duration_from_seconds(time_s)}; }

class LineCamerasTest : public ::testing::Test {
 protected:
  LineCamerasTest() {
    Shooting shooting;
    shooting.duration_s = 4.0;
    events_ = shot(webcam_model(), {at_rest(kMiddle)}, shooting);
  }

  /// Feeds the pictures that arrive in [from_s, to_s) of both cameras or of one.
  std::vector<Measurement> feed(double from_s, double to_s, std::optional<Side> only = std::nullopt) {
    std::vector<Measurement> found;
    for (const Event& event : events_) {
      const auto& seen = std::get<Observation>(event);
      if (seen.arrived < at(from_s) || seen.arrived >= at(to_s) || (only && seen.side != *only)) continue;
      if (const auto measurement = line_.step(event)) found.push_back(*measurement);
    }
    return found;
  }

  Line line_{shared_model(webcam_model())};
  std::vector<Event> events_;  // one every 1/30 s from 1 s on, both cameras together
};

TEST_F(LineCamerasTest, ALostCameraPublishesOneFaultWithoutAHeartbeat) {
  feed(0.0, 2.0);
  const auto lost = line_.step(CameraLost{Side::kRight, at(2.0)});
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->faults, Faults{Fault::kRightCameraLost});
  EXPECT_FALSE(lost->common_time);
  EXPECT_FALSE(lost->pose);
  EXPECT_FALSE(line_.step(CameraLost{Side::kRight, at(2.01)})) << "once";
  EXPECT_TRUE(feed(2.0, 2.5, Side::kLeft).empty()) << "no common time with one camera";
}

TEST_F(LineCamerasTest, BothLostAreBothNamed) {
  feed(0.0, 2.0);
  line_.step(CameraLost{Side::kRight, at(2.0)});
  const auto lost = line_.step(CameraLost{Side::kLeft, at(2.0)});
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->faults, (Faults{Fault::kLeftCameraLost, Fault::kRightCameraLost}));
}

TEST_F(LineCamerasTest, AReturnedCameraPublishesOnceAndMeasuringResumes) {
  feed(0.0, 2.0);
  line_.step(CameraLost{Side::kRight, at(2.0)});
  const auto back = line_.step(CameraBack{Side::kRight, at(2.5)});
  ASSERT_TRUE(back);
  EXPECT_FALSE(back->common_time);
  EXPECT_FALSE(back->pose);
  EXPECT_FALSE(back->faults.contains(Fault::kRightCameraLost));
  EXPECT_FALSE(back->faults.empty()) << "no pose without a cause";
  feed(2.5, 2.6, Side::kLeft);
  const auto resumed = feed(2.6, 3.0);
  ASSERT_FALSE(resumed.empty());
  EXPECT_TRUE(resumed.back().pose);
  EXPECT_TRUE(resumed.back().common_time);
}

TEST_F(LineCamerasTest, APictureOfALostCameraBringsItBackToo) {
  feed(0.0, 2.0);
  line_.step(CameraLost{Side::kRight, at(2.0)});
  const auto found = feed(2.0, 2.5);
  ASSERT_GT(found.size(), 2U);
  EXPECT_FALSE(found.front().common_time);
  EXPECT_TRUE(found.back().pose);
}

TEST_F(LineCamerasTest, SilenceIsNoticedByATickOnce) {
  feed(0.0, 2.0);
  feed(2.0, 2.11, Side::kLeft);
  EXPECT_FALSE(line_.step(Tick{at(2.05)})) << "the limit is 100 ms";
  const auto lost = line_.step(Tick{at(2.115)});
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->faults, Faults{Fault::kRightCameraLost});
  EXPECT_FALSE(lost->common_time);
  EXPECT_FALSE(line_.step(Tick{at(2.12)}));
}

TEST_F(LineCamerasTest, SilenceIsNoticedWithoutTicksByTheOtherCamera) {
  feed(0.0, 2.0);
  const auto found = feed(2.0, 2.5, Side::kLeft);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faults, Faults{Fault::kRightCameraLost});
}

TEST_F(LineCamerasTest, ACameraThatNeverCameIsLost) {
  Line line(shared_model(webcam_model()));
  EXPECT_FALSE(line.step(Tick{at(1.0)}));
  EXPECT_FALSE(line.step(Tick{at(1.09)}));
  const auto lost = line.step(Tick{at(1.11)});
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->faults, (Faults{Fault::kLeftCameraLost, Fault::kRightCameraLost}));
}

TEST_F(LineCamerasTest, ACameraThatRepeatsItselfIsLostWithinThreePictures) {
  feed(0.0, 2.0);
  for (Event& event : events_) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == Side::kRight) seen.health.identical = true;
  }
  const auto found = feed(2.0, 2.5);
  ASSERT_FALSE(found.empty());
  ASSERT_LE(found.size(), 3U);
  EXPECT_EQ(found.back().faults, Faults{Fault::kRightCameraLost});
  EXPECT_FALSE(found.back().common_time);
}

TEST_F(LineCamerasTest, ARepeatedPictureNeitherIsMeasuredNorBringsACameraBack) {
  feed(0.0, 2.0);
  Observation old;
  old.side = Side::kRight;
  old.arrived = old.exposed = at(2.01);
  old.health.identical = true;
  EXPECT_FALSE(line_.step(old)) << "one repeat is a frame left out";
  ASSERT_TRUE(line_.step(CameraLost{Side::kRight, at(2.02)}));
  for (const double t_s : {2.03, 2.04, 2.05}) {
    old.arrived = old.exposed = at(t_s);
    EXPECT_FALSE(line_.step(old));
  }
  EXPECT_EQ(line_.step(CameraLost{Side::kLeft, at(2.06)})->faults,
            (Faults{Fault::kLeftCameraLost, Fault::kRightCameraLost}));
}

TEST_F(LineCamerasTest, TicksAloneGiveNoVerdict) {
  feed(0.0, 2.0);
  // the last pictures arrived at 1.977 s
  for (int ms = 0; ms < 75; ++ms) EXPECT_FALSE(line_.step(Tick{at(2.0 + ms * 1e-3)}));
}

TEST_F(LineCamerasTest, StampsThatNoQueueCanJoinAreATimingFaultInTime) {
  feed(0.0, 2.0);
  for (Event& event : events_) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == Side::kLeft && seen.arrived >= at(2.0)) seen.exposed -= std::chrono::milliseconds(400);
  }
  const auto found = feed(2.0, 3.0);
  ASSERT_FALSE(found.empty());
  // the step is believed after four pictures
  for (const Measurement& measurement : found) EXPECT_TRUE(!measurement.pose || measurement.exposed < at(2.2));
  EXPECT_GE(found.back().exposed, at(2.7)) << "again and again: at least every 200 ms and a picture";
  EXPECT_EQ(found.back().faults, Faults{Fault::kTimingBound});
  EXPECT_FALSE(found.back().common_time) << "the heart stands still";
}

TEST_F(LineCamerasTest, StampsThatStandStillAreATimingFaultInTime) {
  Line line(shared_model(webcam_model()));
  std::vector<Measurement> found;
  for (Event event : events_) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == Side::kLeft) seen.exposed = at(1.0);
    if (const auto measurement = line.step(event); measurement && seen.arrived > at(2.0)) found.push_back(*measurement);
  }
  ASSERT_GE(found.size(), 12U) << "3 s, at least every 200 ms and a picture";
  EXPECT_LE(found.size(), 15U) << "and not sooner: a camera that falls silent is named first";
  for (const Measurement& measurement : found) EXPECT_EQ(measurement.faults, Faults{Fault::kTimingBound});
}

TEST_F(LineCamerasTest, SequenceNumbersCountEveryMeasurement) {
  std::uint64_t last = 0;
  for (const Measurement& measurement : feed(0.0, 2.0)) EXPECT_EQ(measurement.sequence, ++last);
  EXPECT_EQ(line_.step(CameraLost{Side::kRight, at(2.0)})->sequence, last + 1);
}

TEST_F(LineCamerasTest, ANewModelMeasuresOnlyPicturesTakenAfterItAndKeepsTheClocks) {
  const auto before = feed(0.0, 2.0);
  ASSERT_TRUE(before.back().pose);
  EXPECT_FALSE(line_.forecast().points.empty());
  LineModel moved = webcam_model();
  moved.output_from_rig.translation() = Vec3(5.0, 0.0, 0.0);
  line_.swap_model(shared_model(moved));
  EXPECT_TRUE(line_.forecast().points.empty());
  const auto after = feed(2.0, 3.0);
  ASSERT_GT(after.size(), 20U);
  EXPECT_EQ(after.front().timing.speed_mm_per_s, 0.0) << "the motion is dropped";
  EXPECT_LE(after.front().timing.skew_sigma_s, before.back().timing.skew_sigma_s * 1.01) << "the clocks are kept";
  ASSERT_TRUE(after.back().pose);
  // 0.2 mm: five sigma of x at 0.05 px (0.023 mm) and its moves through the tilted frame
  EXPECT_NEAR(after.back().pose->position_in_output_mm.x(), kMiddle.x() + 5.0, 0.2);
}

TEST_F(LineCamerasTest, WithoutAModelNothingIsForecast) {
  line_.swap_model(nullptr);
  feed(0.0, 2.0);
  EXPECT_TRUE(line_.forecast().points.empty());
}

TEST_F(LineCamerasTest, ACameraThatRestartsItsNumbersIsMeasuredAgain) {
  feed(0.0, 2.0);
  for (Event& event : events_) {
    auto& seen = std::get<Observation>(event);
    if (seen.side == Side::kRight) seen.frame -= 25;
  }
  const auto found = feed(2.0, 2.5);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.back().pose);
}

}  // namespace
}  // namespace tripoint
