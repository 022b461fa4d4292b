#include "recording/recorded_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recording_folder.h"

namespace tripoint {
namespace {

using test::RecordingFolder;
using namespace std::chrono_literals;

/// Time passes only by waiting.
class WaitingClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
  [[nodiscard]] bool synchronised() const override { return false; }
  void wait_until(TimePoint time) { now_ = std::max(now_, time); }
  void pass(Duration duration) { now_ += duration; }

 private:
  TimePoint now_ = time_from_ns(5'000'000'000);
};

/// Left at 0, 40, 80 ms and right at 10 ms after the first arrival, which is at 1 s in the recording.
class RecordedCameraTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.describe("yuyv");
    for (const int index : {1, 2, 3}) folder_.picture("left", index, static_cast<char>('0' + index));
    folder_.picture("right", 8, '8');
    folder_.rows(
        "left,1,990000000,1000000000\nright,8,1000000000,1010000000\n"
        "left,2,1030000000,1040000000\nleft,3,1070000000,1080000000\n");
  }

  RecordedCamera::Opener opener(Side side) {
    auto made = RecordedCamera::opener(folder_.path(), side,
                                       {clock_, [this](TimePoint time) { clock_.wait_until(time); }, clock_.now()});
    EXPECT_TRUE(made);
    return *made;
  }
  std::unique_ptr<Camera> camera(Side side) { return std::move(*opener(side)()); }

  RecordingFolder folder_;
  WaitingClock clock_;
};

TEST_F(RecordedCameraTest, FramesArriveAsTheyDidAndTheirTimesAreMovedToNow) {
  const auto left = camera(Side::kLeft);
  const TimePoint start = clock_.now();
  for (int i = 0; i < 3; ++i) {
    const auto frame = left->next_frame(500ms);
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_EQ(frame->sequence, static_cast<std::uint32_t>(i + 1));
    EXPECT_EQ(frame->arrived, start + i * 40ms);
    EXPECT_EQ(frame->exposed, start + i * 40ms - 10ms);
    EXPECT_EQ(clock_.now(), frame->arrived);
  }
}

TEST_F(RecordedCameraTest, BothSidesKeepTheirTimesAgainstEachOther) {
  const TimePoint start = clock_.now();
  const auto right = camera(Side::kRight);
  const auto frame = right->next_frame(500ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->arrived, start + 10ms);
  EXPECT_EQ(frame->data[0], '8');
}

TEST_F(RecordedCameraTest, AGapLongerThanTheLimitIsATimeout) {
  const auto left = camera(Side::kLeft);
  ASSERT_TRUE(left->next_frame(10ms));
  const TimePoint asked = clock_.now();
  const auto frame = left->next_frame(10ms);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kTimeout);
  EXPECT_EQ(clock_.now(), asked + 10ms);
}

TEST_F(RecordedCameraTest, FramesThatNobodyFetchedInTimeAreLeftOut) {
  const auto left = camera(Side::kLeft);
  ASSERT_TRUE(left->next_frame(500ms));
  clock_.pass(100ms);
  const auto frame = left->next_frame(500ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 3U);
}

TEST_F(RecordedCameraTest, TheEndIsSaid) {
  const auto right = camera(Side::kRight);
  ASSERT_TRUE(right->next_frame(500ms));
  for (int i = 0; i < 2; ++i) {
    const auto frame = right->next_frame(1ms);
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::kEndOfStream);
    EXPECT_THAT(frame.error().message, testing::AllOf(testing::StartsWith("right (recording "),
                                                      testing::HasSubstr("has ended after 1 frames")));
  }
}

TEST_F(RecordedCameraTest, TheNextOpeningGoesOnWhereTheOneBeforeStopped) {
  const auto open = opener(Side::kLeft);
  ASSERT_TRUE((*open())->next_frame(500ms));
  const auto frame = (*open())->next_frame(500ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 2U);
}

TEST_F(RecordedCameraTest, AMissingPictureIsADamagedFrame) {
  std::filesystem::remove(folder_.path() / "left/00000001.yuyv");
  const auto left = camera(Side::kLeft);
  const auto damaged = left->next_frame(1ms);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, ErrorCode::kCorruptFrame);
  EXPECT_TRUE(left->next_frame(500ms));
}

TEST_F(RecordedCameraTest, InfoTellsSizeFormatAndRate) {
  const auto left = camera(Side::kLeft);
  EXPECT_EQ(left->info().size, (ImageSize{16, 16}));
  EXPECT_EQ(left->info().format, PixelFormat::kYuyv);
  EXPECT_DOUBLE_EQ(left->info().rate_hz, 25.0);
}

TEST_F(RecordedCameraTest, AFolderThatCannotBeReadIsKnownBeforeOpening) {
  const auto made = RecordedCamera::opener(folder_.path() / "nowhere", Side::kLeft, {clock_, {}, clock_.now()});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kCannotRead);
}

}  // namespace
}  // namespace tripoint
