// What a worker does when its camera goes away, and when it comes back.
#include <gtest/gtest.h>

#include "capture/camera_worker.h"
#include "scripted_camera.h"

namespace tripoint {
namespace {

using test::Script;
using test::ScriptedFrame;
using test::WorkerBench;
using namespace std::chrono_literals;

const Error kSilent{ErrorCode::kTimeout, "no frame for 500 ms"};
const Error kGone{ErrorCode::kDeviceMissing, "unplugged"};
const Error kDamaged{ErrorCode::kCorruptFrame, "truncated"};

TEST(CameraLossTest, ASilentCameraIsLostOnceAndComesBack) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}, kSilent}, Script{ScriptedFrame{0, 2}}});
  bench.run();
  ASSERT_EQ(bench.events().size(), 4U);
  EXPECT_TRUE(std::holds_alternative<Observation>(bench.events()[0]));
  EXPECT_TRUE(std::holds_alternative<CameraLost>(bench.events()[1]));
  EXPECT_TRUE(std::holds_alternative<CameraBack>(bench.events()[2]));
  EXPECT_TRUE(std::holds_alternative<Observation>(bench.events()[3]));
  EXPECT_EQ(std::get<CameraLost>(bench.events()[1]).at, time_from_ns(7));
  EXPECT_EQ(bench.status().losses, 1U);
}

TEST(CameraLossTest, ACameraMissingFromTheStartIsLostOnce) {
  WorkerBench bench({kGone, kGone, kGone, Script{ScriptedFrame{1, 1}}});
  bench.run();
  EXPECT_EQ(bench.count<CameraLost>(), 1U);
  EXPECT_EQ(bench.count<CameraBack>(), 1U);
  EXPECT_EQ(bench.count<Observation>(), 1U);
}

TEST(CameraLossTest, ThePauseGrowsToItsLimit) {
  WorkerBench bench({kGone, kGone, kGone, kGone, kGone, kGone, Script{ScriptedFrame{1, 1}}});
  bench.run();
  EXPECT_EQ(bench.pauses(), (std::vector<Duration>{200ms, 400ms, 800ms, 1600ms, 2s, 2s}));
}

TEST(CameraLossTest, ThePauseIsShortAgainAfterFrames) {
  WorkerBench bench({kGone, kGone, Script{ScriptedFrame{1, 1}, kGone}, Script{ScriptedFrame{1, 1}}});
  bench.run();
  EXPECT_EQ(bench.pauses(), (std::vector<Duration>{200ms, 400ms, 200ms}));
}

TEST(CameraLossTest, ACameraThatOpensButStaysSilentIsTriedEverLessOften) {
  WorkerBench bench({Script{kSilent}, Script{kSilent}, Script{kSilent}, Script{ScriptedFrame{1, 1}}});
  bench.run();
  EXPECT_EQ(bench.pauses(), (std::vector<Duration>{200ms, 400ms, 800ms}));
  EXPECT_EQ(bench.count<CameraLost>(), 1U);
}

TEST(CameraLossTest, FourDamagedFramesInARowAreBorne) {
  WorkerBench bench(
      {Script{kDamaged, kDamaged, kDamaged, kDamaged, ScriptedFrame{1, 1}, kDamaged, ScriptedFrame{3, 3}}});
  bench.run();
  EXPECT_EQ(bench.count<CameraLost>(), 0U);
  EXPECT_EQ(bench.count<Observation>(), 2U);
  EXPECT_EQ(bench.status().corrupt, 5U);
}

TEST(CameraLossTest, FiveDamagedFramesInARowAreALoss) {
  WorkerBench bench(
      {Script{ScriptedFrame{1, 1}, kDamaged, kDamaged, kDamaged, kDamaged, kDamaged}, Script{ScriptedFrame{1, 1}}});
  bench.run();
  EXPECT_EQ(bench.count<CameraLost>(), 1U);
}

std::string last_error(const std::string& message) {
  WorkerBench bench({Error{ErrorCode::kDeviceMissing, message}, Script{ScriptedFrame{1, 1}}});
  bench.run();
  return bench.status().last_error;
}

TEST(CameraLossTest, TheLastErrorNamesTheSideOnceAndTheCause) {
  EXPECT_EQ(last_error("unplugged"), "camera left: unplugged");
  EXPECT_EQ(last_error("left (usb 1-1): unplugged"), "camera left (usb 1-1): unplugged");
  EXPECT_EQ(last_error("camera left: no camera with port 1-1"), "camera left: no camera with port 1-1");
}

TEST(CameraLossTest, TheEndOfARecordingEndsTheWorker) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}, Error{ErrorCode::kEndOfStream, "over"}, ScriptedFrame{2, 2}},
                     Script{ScriptedFrame{3, 3}}});
  bench.run();
  EXPECT_EQ(bench.count<Observation>(), 1U);
  EXPECT_EQ(bench.count<CameraLost>(), 1U);
  EXPECT_TRUE(bench.pauses().empty());
}

TEST(CameraLossTest, StoppingIsNotALoss) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}, ScriptedFrame{2, 2}}});
  bench.run();
  EXPECT_EQ(bench.count<CameraLost>(), 0U);
  EXPECT_EQ(bench.status().losses, 0U);
}

}  // namespace
}  // namespace tripoint
