// An open camera: frames, and everything that can happen instead of one.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>
#include <poll.h>

#include <cerrno>

#include "devices/v4l2_camera.h"
#include "devices/v4l2_format.h"
#include "fake_v4l2_driver.h"

namespace tripoint {
namespace {

using test::FakeFrame;
using test::FakeWait;
using testing::HasSubstr;
using namespace std::chrono_literals;

class V4l2StreamTest : public testing::Test {
 protected:
  void SetUp() override { open_camera(); }
  void open_camera() {
    camera_.reset();
    auto opened = V4l2Camera::open(settings_, driver_, clock_);
    ASSERT_TRUE(opened) << opened.error().message;
    camera_ = std::move(*opened);
  }
  void will_deliver(std::vector<FakeFrame> frames, Duration after = 20ms) {
    driver_.waits.push_back({after, std::move(frames)});
  }
  Error refusal(Duration limit = 500ms) {
    const auto frame = camera_->next_frame(limit);
    EXPECT_FALSE(frame);
    return frame ? Error{ErrorCode::kEndOfStream} : frame.error();
  }

  test::WaitingClock clock_;
  test::FakeV4l2Driver driver_{clock_};
  V4l2Settings settings_{.side = Side::kLeft,
                         .node = "/dev/video0",
                         .exposure = std::chrono::microseconds(4000),
                         .line_time = Duration{30'000}};
  std::unique_ptr<V4l2Camera> camera_;
};

TEST_F(V4l2StreamTest, AFrameLooksIntoTheDriversBuffer) {
  will_deliver({{.sequence = 17, .value = 42, .stamp_us = 9'999'000}});
  const auto frame = camera_->next_frame(500ms);
  ASSERT_TRUE(frame) << frame.error().message;
  EXPECT_EQ(frame->side, Side::kLeft);
  EXPECT_EQ(frame->format, PixelFormat::kYuyv);
  EXPECT_EQ(frame->size, (ImageSize{640, 480}));
  EXPECT_EQ(frame->stride_bytes, 1280U);
  EXPECT_EQ(frame->data.size(), 1280U * 480U);
  EXPECT_EQ(frame->data[12345], 42);
  EXPECT_EQ(frame->sequence, 17U);
  EXPECT_EQ(frame->line_time, Duration{30'000});
  EXPECT_EQ(frame->arrived, clock_.now());
}

TEST_F(V4l2StreamTest, EveryFormatComesInEverySize) {
  struct Format {
    PixelFormat format;
    std::uint32_t fourcc;
    std::size_t bytes_of_pixel;
    bool in_rows;
  };
  for (const Format& given : {Format{PixelFormat::kYuyv, V4L2_PIX_FMT_YUYV, 2, true},
                              Format{PixelFormat::kMjpeg, V4L2_PIX_FMT_MJPEG, 2, false},
                              Format{PixelFormat::kGrey, V4L2_PIX_FMT_GREY, 1, true}}) {
    for (const ImageSize size : {ImageSize{320, 240}, ImageSize{640, 480}, ImageSize{1280, 720}}) {
      SCOPED_TRACE(fmt::format("{} {}x{}", name(given.format), size.width_px, size.height_px));
      const auto width = static_cast<std::size_t>(size.width_px);
      driver_.fourcc = given.fourcc;
      driver_.width = static_cast<std::uint32_t>(size.width_px);
      driver_.height = static_cast<std::uint32_t>(size.height_px);
      settings_.format = given.format;
      settings_.size = size;
      open_camera();
      will_deliver({{.sequence = 3, .value = 42}});
      const auto frame = camera_->next_frame(500ms);
      ASSERT_TRUE(frame) << frame.error().message;
      EXPECT_EQ(frame->format, given.format);
      EXPECT_EQ(frame->size, size);
      EXPECT_EQ(frame->stride_bytes, given.in_rows ? width * given.bytes_of_pixel : 0);
      EXPECT_EQ(frame->data.size(), width * given.bytes_of_pixel * static_cast<std::size_t>(size.height_px));
    }
  }
}

TEST_F(V4l2StreamTest, TheStampBecomesTheMiddleOfTheExposure) {
  will_deliver({{.stamp_us = 9'999'000}});
  // The driver's flag says start of exposure, as uvcvideo always does; the stamp is the first byte's.
  EXPECT_EQ(camera_->next_frame(500ms)->exposed, time_from_ns(9'999'000'000) - 2ms);
}

TEST_F(V4l2StreamTest, StampsOfTheCamerasClockStandForTheStart) {
  driver_.stamps = StampPoint::kStartOfExposure;
  open_camera();
  will_deliver({{.stamp_us = 9'999'000}});
  EXPECT_EQ(camera_->next_frame(500ms)->exposed, time_from_ns(9'999'000'000) + 2ms);
}

TEST_F(V4l2StreamTest, AStampOfAnotherClockIsAFault) {
  will_deliver({{.stamp_us = 9'999'000, .monotonic = false}});
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kDeviceFault);
  EXPECT_THAT(error.message, HasSubstr("monotonic clock"));
}

TEST_F(V4l2StreamTest, OnlyTheNewestOfSeveralFramesIsHandedOut) {
  will_deliver({{.sequence = 1}, {.sequence = 2}, {.sequence = 3, .value = 3}});
  const auto frame = camera_->next_frame(500ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 3U);
  EXPECT_EQ(frame->data[0], 3);
  EXPECT_EQ(driver_.buffers_with_driver(), 3U);  // of four: one is being looked at
}

TEST_F(V4l2StreamTest, BuffersGoRoundForEver) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    will_deliver({{.sequence = i}});
    ASSERT_TRUE(camera_->next_frame(500ms)) << i;
    ASSERT_EQ(driver_.buffers_with_driver(), 3U);
  }
}

TEST_F(V4l2StreamTest, SilenceIsATimeoutAfterTheLimit) {
  const TimePoint asked = clock_.now();
  const Error error = refusal(300ms);
  EXPECT_EQ(error.code, ErrorCode::kTimeout);
  EXPECT_THAT(error.message, HasSubstr("no frame for 300 ms"));
  EXPECT_EQ(clock_.now(), asked + 300ms);
}

TEST_F(V4l2StreamTest, AWakeUpWithoutAFrameWaitsOn) {
  will_deliver({});
  will_deliver({{.sequence = 5}});
  const auto frame = camera_->next_frame(500ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 5U);
}

TEST_F(V4l2StreamTest, WakeUpsWithoutFramesEndAtTheLimit) {
  for (int i = 0; i < 100; ++i) will_deliver({}, 10ms);
  EXPECT_EQ(refusal(100ms).code, ErrorCode::kTimeout);
}

TEST_F(V4l2StreamTest, AFrameThatTheDriverMarkedIsCorrupt) {
  will_deliver({{.sequence = 1, .damaged = true}});
  EXPECT_EQ(refusal().code, ErrorCode::kCorruptFrame);
  will_deliver({{.sequence = 2}});
  EXPECT_TRUE(camera_->next_frame(500ms));
  EXPECT_EQ(driver_.buffers_with_driver(), 3U);  // the damaged one went back
}

TEST_F(V4l2StreamTest, AFrameThatIsShortByAByteIsCorrupt) {
  will_deliver({{.sequence = 1, .missing_bytes = 1}});
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kCorruptFrame);
  EXPECT_THAT(error.message, HasSubstr("614399 of 614400 bytes"));
}

TEST_F(V4l2StreamTest, AFrameThatTheDriverLostIsCorrupt) {
  will_deliver({});
  driver_.failures[VIDIOC_DQBUF] = -EIO;
  EXPECT_EQ(refusal().code, ErrorCode::kCorruptFrame);
}

TEST_F(V4l2StreamTest, AnEmptyFrameIsCorrupt) {
  will_deliver({{.sequence = 1, .missing_bytes = 1280 * 480}});
  EXPECT_EQ(refusal().code, ErrorCode::kCorruptFrame);
}

TEST_F(V4l2StreamTest, AFrameBeforeALostOneIsHandedOutAndItsBufferGoesRound) {
  for (std::uint32_t i = 0; i < 10; ++i) {
    will_deliver({{.sequence = i, .lost_after = true}});
    ASSERT_TRUE(camera_->next_frame(500ms)) << i;
    ASSERT_EQ(driver_.buffers_with_driver(), 3U);
  }
}

TEST_F(V4l2StreamTest, AStreamThatBrokeOffIsNoDamagedFrame) {
  driver_.waits.push_back({0ms, {}, POLLERR});
  driver_.failures[VIDIOC_DQBUF] = -EIO;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
}

TEST_F(V4l2StreamTest, UnpluggingIsAMissingDevice) {
  driver_.waits.push_back({0ms, {}, POLLERR | POLLHUP});
  driver_.failures[VIDIOC_DQBUF] = -ENODEV;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
}

TEST_F(V4l2StreamTest, AStreamThatHungUpIsAMissingDevice) {
  driver_.waits.push_back({0ms, {}, POLLHUP});
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
}

TEST_F(V4l2StreamTest, UnpluggingBetweenFramesIsAMissingDevice) {
  will_deliver({{.sequence = 1}});
  ASSERT_TRUE(camera_->next_frame(500ms));
  driver_.failures[VIDIOC_QBUF] = -ENODEV;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
}

TEST_F(V4l2StreamTest, AnErrorOfPollIsHandedOn) {
  driver_.waits.push_back({0ms, {}, -ENOMEM});
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceFault);
}

}  // namespace
}  // namespace tripoint
