#include "sim/frame_schedule.h"

#include <cmath>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

constexpr TimePoint kStart = time_from_ns(7'000'000'000);
constexpr int kFrames = 20'000;

SimulationSettings clocked_settings(const CameraClock& right) {
  SimulationSettings settings = bare_settings();
  settings.rate_hz = 25.0;
  settings.exposure = std::chrono::milliseconds{4};
  settings.line_time = std::chrono::microseconds{50};
  settings.clocks.right = right;
  return settings;
}

TEST(FrameScheduleTest, FramesComeAtTheRateFromThePhaseOn) {
  const SimulatedWorld world = world_of(clocked_settings({.phase = std::chrono::milliseconds{13}}), kStart);
  EXPECT_EQ(FrameSchedule(world, Side::kLeft).exposed(0), kStart);
  const FrameSchedule right(world, Side::kRight);
  EXPECT_EQ(right.exposed(0), kStart + std::chrono::milliseconds{13});
  EXPECT_EQ(right.exposed(100) - right.exposed(0), std::chrono::seconds{4});
  EXPECT_EQ(right.stamp(100), right.exposed(100));
}

TEST(FrameScheduleTest, DriftIsInPartsPerMillionOfThePeriod) {
  const SimulatedWorld world = world_of(clocked_settings({.drift_ppm = 50.0}), kStart);
  const FrameSchedule left(world, Side::kLeft);
  const FrameSchedule right(world, Side::kRight);
  // 25,000 frames are 1000 s; 50 ppm of that are 50 ms
  EXPECT_EQ(right.exposed(25'000) - left.exposed(25'000), std::chrono::milliseconds{50});
}

TEST(FrameScheduleTest, StampsJitterNormallyAroundTheLatency) {
  const SimulatedWorld world = world_of(
      clocked_settings({.stamp_jitter = std::chrono::milliseconds{3}, .stamp_latency = std::chrono::milliseconds{8}}),
      kStart);
  const FrameSchedule right(world, Side::kRight);
  double sum_ms = 0.0;
  double squares_ms2 = 0.0;
  double neighbours_ms2 = 0.0;
  double last_ms = 0.0;
  int beyond_two_sigma = 0;
  for (std::uint64_t i = 0; i < kFrames; ++i) {
    const double late_ms = 1e3 * seconds(right.stamp(i) - right.exposed(i)) - 8.0;
    sum_ms += late_ms;
    squares_ms2 += late_ms * late_ms;
    neighbours_ms2 += late_ms * last_ms;
    beyond_two_sigma += std::abs(late_ms) > 6.0 ? 1 : 0;
    last_ms = late_ms;
  }
  const double root = std::sqrt(static_cast<double>(kFrames));  // five standard deviations of each estimate below
  EXPECT_NEAR(sum_ms / kFrames, 0.0, 5.0 * 3.0 / root);
  EXPECT_NEAR(squares_ms2 / kFrames, 9.0, 5.0 * 9.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(neighbours_ms2 / kFrames, 0.0, 5.0 * 9.0 / root);
  EXPECT_NEAR(static_cast<double>(beyond_two_sigma) / kFrames, 0.0455, 5.0 * std::sqrt(0.0455 * 0.9545) / root);
}

TEST(FrameScheduleTest, CamerasJitterIndependently) {
  SimulationSettings settings = clocked_settings({.stamp_jitter = std::chrono::milliseconds{3}});
  settings.clocks.left = settings.clocks.right;
  const SimulatedWorld world = world_of(settings, kStart);
  const FrameSchedule left(world, Side::kLeft);
  const FrameSchedule right(world, Side::kRight);
  double product_ms2 = 0.0;
  for (std::uint64_t i = 0; i < kFrames; ++i) {
    product_ms2 += 1e6 * seconds(left.stamp(i) - left.exposed(i)) * seconds(right.stamp(i) - right.exposed(i));
  }
  EXPECT_NEAR(product_ms2 / kFrames, 0.0, 5.0 * 9.0 / std::sqrt(static_cast<double>(kFrames)));
}

TEST(FrameScheduleTest, FrameIsReadyWhenItsLastRowIsExposed) {
  const SimulatedWorld world = world_of(clocked_settings({}), kStart);
  const FrameSchedule left(world, Side::kLeft);
  // half of 4 ms after the middle of row 0, plus 479 rows of 50 us
  EXPECT_EQ(left.ready(3) - left.exposed(3), std::chrono::microseconds{2000 + 479 * 50});
}

TEST(FrameScheduleTest, NewestReadyFrameChangesExactlyWhenOneGetsReady) {
  const SimulatedWorld world = world_of(clocked_settings({.drift_ppm = -37.0}), kStart);
  const FrameSchedule right(world, Side::kRight);
  EXPECT_EQ(right.newest_ready(kStart), 0U);
  for (const std::uint64_t frame : {1U, 2U, 77U, 100'001U}) {
    EXPECT_EQ(right.newest_ready(right.ready(frame)), frame);
    EXPECT_EQ(right.newest_ready(right.ready(frame) - Duration{2}), frame - 1);
  }
}

}  // namespace
}  // namespace tripoint
