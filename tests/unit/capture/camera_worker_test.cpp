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

TEST(CameraWorkerTest, TheDetectorGetsEachPictureWithItsNumber) {
  const auto flat = [](int, int) { return 90; };
  WorkerBench bench(
      {Script{ScriptedFrame{7, 1}, ScriptedFrame{9, 0, test::jpeg_of({test::kScriptedSize, flat, flat, flat}, {})}}});
  bench.run();
  EXPECT_EQ(bench.numbers_seen, (std::vector<std::uint32_t>{7, 9}));
}

TEST(CameraWorkerTest, ADetectorThatDidNotLookEverywhereSaysSo) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}}});
  bench.looked_at = Coverage::kRegions;
  bench.run();
  ASSERT_EQ(bench.observations().size(), 1U);
  EXPECT_EQ(bench.observations()[0].coverage, Coverage::kRegions);
}

TEST(CameraWorkerTest, MjpegIsDecodedForTheDetector) {
  const auto flat = [](int, int) { return 90; };
  WorkerBench bench({Script{ScriptedFrame{1, 0, test::jpeg_of({test::kScriptedSize, flat, flat, flat}, {})}}});
  bench.run();
  ASSERT_EQ(bench.luma_seen.size(), 1U);
  EXPECT_NEAR(bench.luma_seen[0], 90, 1);
}

/// Frames of flat grey, each another.
Script grey_jpegs(std::uint32_t first, std::uint32_t last) {
  Script script;
  for (std::uint32_t frame = first; frame <= last; ++frame) {
    const auto flat = [frame](int, int) { return 100 + static_cast<int>(frame); };
    constexpr ImageSize kSize{64, 480};
    script.push_back(
        ScriptedFrame{.sequence = frame, .mjpeg = test::jpeg_of({kSize, flat, flat, flat}, {}), .mjpeg_size = kSize});
  }
  return script;
}

void forecast_spot(WorkerBench& bench, std::uint32_t frame) {
  bench.spot = {30.0, 240.0};
  Forecast forecast{.number = 9, .at = TimePoint{} + frame * test::kScriptedPeriod, .points = {}};
  ForecastPoint point;
  point.at = {bench.spot, bench.spot};
  point.covariance_px2 = {Matrix2::Identity(), Matrix2::Identity()};
  forecast.points.push_back(point);
  bench.forecast.put(forecast);
}

TEST(CameraWorkerTest, MjpegIsDecodedAroundTheForecastBetweenWholePictures) {
  WorkerBench bench({grey_jpegs(1, 7)});
  forecast_spot(bench, 4);
  bench.run();
  // The forecast is good within 70 ms of frame 4, frames 3 to 5; before frame 3 nothing was foreseen.
  const std::vector<Coverage> expected{Coverage::kWholeFrame, Coverage::kWholeFrame, Coverage::kWholeFrame,
                                       Coverage::kRegions,    Coverage::kRegions,    Coverage::kWholeFrame,
                                       Coverage::kWholeFrame};
  const std::vector<Observation> seen = bench.observations();
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].coverage, expected[i]) << i;
    EXPECT_FALSE(seen[i].health.identical) << i;
  }
  // Pixel (0, 0) lies outside the band.
  EXPECT_EQ(bench.luma_seen, (std::vector<int>{101, 102, 103, 103, 103, 106, 107}));
}

TEST(CameraWorkerTest, WhatIsSiftedIsSeenWholeAndFinished) {
  WorkerBench bench({grey_jpegs(1, 7)});
  forecast_spot(bench, 4);
  std::vector<std::uint32_t> sifted;
  bench.sift = [&](const Observation& seen, const Picture& picture) {
    sifted.push_back(seen.frame);
    EXPECT_EQ(seen.coverage, Coverage::kWholeFrame) << seen.frame;
    EXPECT_EQ(picture.luma.at(0, 0), 100 + static_cast<int>(seen.frame));
    Observation believed = seen;
    believed.points.clear();
    return believed;
  };
  bench.run();
  EXPECT_EQ(sifted, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
  for (const Observation& seen : bench.observations()) EXPECT_TRUE(seen.points.empty());
}

TEST(CameraWorkerTest, ACameraThatWasOpenedAnewIsSeenWholeFirst) {
  WorkerBench bench({grey_jpegs(1, 3), grey_jpegs(4, 4)});
  forecast_spot(bench, 3);
  bench.run();
  const std::vector<Observation> seen = bench.observations();
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_EQ(seen[2].coverage, Coverage::kRegions);
  EXPECT_EQ(seen[3].coverage, Coverage::kWholeFrame);
}

TEST(CameraWorkerTest, AJpegThatIsRepeatedIsNoticedWhateverIsDecoded) {
  Script script;
  for (std::uint32_t frame = 1; frame <= 5; ++frame) {
    const auto flat = [frame](int, int) { return frame < 3 ? 100 + static_cast<int>(frame) : 150; };
    constexpr ImageSize kSize{64, 480};
    script.push_back(
        ScriptedFrame{.sequence = frame, .mjpeg = test::jpeg_of({kSize, flat, flat, flat}, {}), .mjpeg_size = kSize});
  }
  WorkerBench bench({script});
  forecast_spot(bench, 3);
  bench.run();
  const std::vector<Observation> seen = bench.observations();
  ASSERT_EQ(seen.size(), 5U);
  EXPECT_EQ(seen[2].coverage, Coverage::kRegions);
  EXPECT_EQ(seen[4].coverage, Coverage::kWholeFrame);
  EXPECT_FALSE(seen[2].health.identical);
  EXPECT_TRUE(seen[3].health.identical);
  EXPECT_TRUE(seen[4].health.identical);
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
