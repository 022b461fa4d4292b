// What a worker does with a camera that delivers on time, but pictures that it has delivered before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/camera_worker.h"
#include "scripted_camera.h"

namespace tripoint {
namespace {

using test::Script;
using test::ScriptedFrame;
using test::WorkerBench;
using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr CameraLimits kLimits{.repeated_in_a_row = 4};

/// The pictures in turn, each with a number and stamps of its own.
Script pictures(const std::vector<std::uint8_t>& values) {
  Script script;
  for (const std::uint8_t value : values) {
    script.emplace_back(ScriptedFrame{static_cast<std::uint32_t>(script.size()), value});
  }
  return script;
}

/// One letter for each event: L lost, B back, n a new picture, r one marked as a repeat.
std::string story(const WorkerBench& bench) {
  std::string letters;
  for (const Event& event : bench.events()) {
    if (std::holds_alternative<CameraLost>(event)) letters += 'L';
    if (std::holds_alternative<CameraBack>(event)) letters += 'B';
    if (const auto* seen = std::get_if<Observation>(&event)) letters += seen->health.identical ? 'r' : 'n';
  }
  return letters;
}

TEST(FrozenCameraTest, IsClosedAndOpenedAnewAndComesBackWithANewPicture) {
  WorkerBench bench({pictures({1, 2, 2, 2, 2, 2, 2, 2}), pictures({3, 4})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nnrrrrLBnn") << "the script's last repeats are not read: the camera was closed";
  EXPECT_THAT(bench.pauses(), ElementsAre(200ms));
  EXPECT_EQ(bench.status().losses, 1U);
}

TEST(FrozenCameraTest, TheFrozenPictureIsNoSignOfLifeAfterTheReopening) {
  WorkerBench bench({pictures({1, 2, 2, 2, 2, 2}), pictures({2, 2, 3})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nnrrrrLBn");
  EXPECT_EQ(bench.luma_seen.back(), 3);
}

TEST(FrozenCameraTest, ThatStaysFrozenIsOpenedEverLessOftenAndLostOnce) {
  const Script frozen = pictures({2, 2, 2, 2});
  WorkerBench bench({pictures({2, 2, 2, 2, 2}), frozen, frozen, frozen, pictures({7})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nrrrrLBn");
  EXPECT_THAT(bench.pauses(), ElementsAre(200ms, 400ms, 800ms, 1600ms));
}

TEST(FrozenCameraTest, ADriverThatGoesRoundInStaleBuffersIsFrozen) {
  WorkerBench bench({pictures({1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4}), pictures({4, 1, 9})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nnnnrrrrLBn");
}

TEST(FrozenCameraTest, SingleRepeatsAreBorne) {
  WorkerBench bench({pictures({1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nrnrnrnrnrnr");
}

TEST(FrozenCameraTest, DamagedPicturesBetweenDoNotHideTheRepeats) {
  const Error damaged{ErrorCode::kCorruptFrame, "truncated"};
  WorkerBench bench({Script{ScriptedFrame{1, 1}, ScriptedFrame{2, 1}, damaged, ScriptedFrame{3, 1}, damaged,
                            ScriptedFrame{4, 1}, damaged, ScriptedFrame{5, 1}, ScriptedFrame{6, 1}},
                     pictures({2})},
                    kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nrrrrLBn");
}

TEST(FrozenCameraTest, APictureFromBeforeALossOfAnotherKindIsNoSignOfLifeEither) {
  WorkerBench bench({Script{ScriptedFrame{1, 1}, Error{ErrorCode::kTimeout, "silent"}}, pictures({1, 2})}, kLimits);
  bench.run();
  EXPECT_EQ(story(bench), "nLBn");
}

TEST(FrozenCameraTest, TheMessageNamesTheSideAndTheRemedy) {
  WorkerBench bench({pictures({1, 1, 1, 1, 1}), pictures({2})}, kLimits);
  bench.run();
  EXPECT_THAT(bench.status().last_error,
              testing::AllOf(HasSubstr("camera left: frozen"), HasSubstr("4 pictures"), HasSubstr("opened anew")));
}

}  // namespace
}  // namespace tripoint
