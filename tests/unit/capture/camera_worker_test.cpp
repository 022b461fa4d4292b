#include "capture/camera_worker.h"

#include <gtest/gtest.h>

#include "scripted_camera.h"
#include "test_pictures.h"

namespace tripoint {
namespace {

using test::Script;
using test::ScriptedFrame;
using test::WorkerBench;

TEST(CameraWorkerTest, AFrameBecomesAnObservationWithItsTimesAndNumber) {
  WorkerBench bench({Script{ScriptedFrame{41, 5}}});
  bench.run();
  ASSERT_EQ(bench.observations().size(), 1U);
  const Observation seen = bench.observations()[0];
  EXPECT_EQ(seen.side, Side::kLeft);
  EXPECT_EQ(seen.frame, 41U);
  EXPECT_EQ(seen.exposed, TimePoint{} + 41 * test::kScriptedPeriod);
  EXPECT_EQ(seen.arrived, seen.exposed + std::chrono::milliseconds(20));
  EXPECT_EQ(seen.line_time, Duration{30'000});
  ASSERT_EQ(seen.points.size(), 1U);
  EXPECT_EQ(seen.points[0].at.u_px, 3.5);
  EXPECT_EQ(bench.luma_seen, std::vector<int>{5});
}

TEST(CameraWorkerTest, AnObservationTellsTheExposureOnlyWhenTheCameraDoes) {
  for (const Duration exposure : {Duration{0}, Duration{2'000'000}}) {
    WorkerBench bench({Script{ScriptedFrame{41, 5}}});
    bench.exposure = exposure;
    bench.run();
    ASSERT_EQ(bench.observations().size(), 1U);
    EXPECT_EQ(bench.observations()[0].exposure.value_or(Duration{0}), exposure);
    EXPECT_EQ(bench.observations()[0].exposure.has_value(), exposure > Duration{0});
  }
}

TEST(CameraWorkerTest, TheFirstFramesNeedNoCameraBack) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}, ScriptedFrame{2, 2}}});
  bench.run();
  EXPECT_EQ(bench.events().size(), 2U);
  EXPECT_TRUE(bench.status().delivering);
}

TEST(CameraWorkerTest, TheDetectorGetsTheNewestForecast) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}}});
  bench.forecast.put({.number = 12, .at = {}, .points = {}});
  bench.run();
  EXPECT_EQ(bench.forecasts_seen, std::vector<std::uint64_t>{12});
  EXPECT_EQ(bench.observations()[0].forecast_used, 12U);
}

TEST(CameraWorkerTest, MjpegIsDecodedForTheDetector) {
  const auto flat = [](int, int) { return 90; };
  WorkerBench bench({Script{ScriptedFrame{1, 0, test::jpeg_of({test::kScriptedSize, flat, flat, flat}, {})}}});
  bench.run();
  ASSERT_EQ(bench.luma_seen.size(), 1U);
  EXPECT_NEAR(bench.luma_seen[0], 90, 1);
}

TEST(CameraWorkerTest, MjpegOfAnotherSizeIsCorrupt) {
  WorkerBench bench({Script{ScriptedFrame{1, 0, test::jpeg_of(test::smooth_picture({32, 8}), {})}}});
  bench.run();
  EXPECT_TRUE(bench.observations().empty());
  EXPECT_EQ(bench.status().corrupt, 1U);
}

TEST(CameraWorkerTest, AnUnpackedFrameThatIsTooShortIsCorrupt) {
  WorkerBench bench({Script{ScriptedFrame{1, 5, {}, 1}, ScriptedFrame{2, 5}}});
  bench.run();
  EXPECT_EQ(bench.observations().size(), 1U);
  EXPECT_EQ(bench.status().corrupt, 1U);
}

TEST(CameraWorkerTest, GapsInTheSequenceAreDroppedFrames) {
  WorkerBench bench({Script{ScriptedFrame{10, 1}, ScriptedFrame{11, 2}, ScriptedFrame{14, 3}}});
  bench.run();
  EXPECT_EQ(bench.status().frames, 3U);
  EXPECT_EQ(bench.status().dropped, 2U);
}

TEST(CameraWorkerTest, TheSequenceMayWrapAround) {
  WorkerBench bench({Script{ScriptedFrame{0xFFFFFFFF, 1}, ScriptedFrame{1, 2}}});
  bench.run();
  EXPECT_EQ(bench.status().dropped, 1U);
}

TEST(CameraWorkerTest, ASequenceThatStartsAgainIsNotALoss) {
  WorkerBench bench({Script{ScriptedFrame{500, 1}, ScriptedFrame{0, 2}}});
  bench.run();
  EXPECT_EQ(bench.status().dropped, 0U);
}

TEST(CameraWorkerTest, RepeatedPicturesAreMarkedFromTheFirstCopy) {
  WorkerBench bench({Script{ScriptedFrame{1, 9}, ScriptedFrame{2, 9}, ScriptedFrame{3, 8}, ScriptedFrame{4, 9}}});
  bench.run();
  const auto seen = bench.observations();
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_FALSE(seen[0].health.identical);
  EXPECT_TRUE(seen[1].health.identical);
  EXPECT_FALSE(seen[2].health.identical);
  EXPECT_TRUE(seen[3].health.identical);
  EXPECT_EQ(bench.status().repeated, 2U);
}

TEST(CameraWorkerTest, TheRateIsThatOfTheArrivals) {
  Script script;
  for (std::uint32_t i = 0; i < 30; ++i) script.emplace_back(ScriptedFrame{i, static_cast<std::uint8_t>(i)});
  WorkerBench bench({script});
  bench.run();
  EXPECT_DOUBLE_EQ(bench.status().rate_hz, 25.0);
}

TEST(PauseTest, EndsAtOnceWhenStopIsRequested) {
  std::stop_source stop;
  stop.request_stop();
  pause_until_stop(std::chrono::hours(1), stop.get_token());
}

}  // namespace
}  // namespace tripoint
