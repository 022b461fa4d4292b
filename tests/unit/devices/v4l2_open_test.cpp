// Opening a camera: the errors of each step, and that nothing stays open after them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>

#include "devices/v4l2_camera.h"
#include "fake_v4l2_driver.h"

namespace tripoint {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class V4l2OpenTest : public testing::Test {
 protected:
  Error refusal() {
    const auto camera = V4l2Camera::open(settings_, driver_, clock_);
    EXPECT_FALSE(camera);
    return camera ? Error{ErrorCode::kEndOfStream} : camera.error();
  }
  ErrorCode code_when(unsigned long request, int failure) {
    driver_.failures = {{request, failure}};
    return refusal().code;
  }

  test::WaitingClock clock_;
  test::FakeV4l2Driver driver_{clock_};
  V4l2Settings settings_{.side = Side::kRight, .node = "/dev/video3", .port = "1-2", .serial = "RIGHT-001"};
};

TEST_F(V4l2OpenTest, InfoIsWhatTheCameraAgreedTo) {
  const auto camera = V4l2Camera::open(settings_, driver_, clock_);
  ASSERT_TRUE(camera) << camera.error().message;
  const CameraInfo& info = (*camera)->info();
  EXPECT_EQ(info.name, "right (usb 1-2, RIGHT-001)");
  EXPECT_EQ(info.port, "1-2");
  EXPECT_EQ(info.serial, "RIGHT-001");
  EXPECT_EQ(info.exposure, std::chrono::microseconds(2000));
  EXPECT_EQ(info.shortest_exposure, std::chrono::microseconds(100));
  EXPECT_EQ(info.longest_exposure, std::chrono::milliseconds(500));
  EXPECT_EQ(info.gain, settings_.gain);
  EXPECT_TRUE(info.gains);
  EXPECT_NEAR(info.rate_hz, 30.0, 0.001);
  EXPECT_THAT((*camera)->info().missing_controls, ElementsAre("gain_automatic"));
}

TEST_F(V4l2OpenTest, TheStreamIsOnAsLongAsTheCameraExists) {
  { const auto camera = V4l2Camera::open(settings_, driver_, clock_); }
  EXPECT_THAT(driver_.log, ElementsAre("open /dev/video3", "on", "off"));
}

TEST_F(V4l2OpenTest, AMissingNodeIsAMissingDeviceAndNamed) {
  driver_.open_failure = -ENOENT;
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kDeviceMissing);
  EXPECT_THAT(error.message, AllOf(HasSubstr("right (usb 1-2"), HasSubstr("/dev/video3")));
}

TEST_F(V4l2OpenTest, MissingPermissionNamesTheGroup) {
  driver_.open_failure = -EACCES;
  EXPECT_THAT(refusal().message, HasSubstr("group video"));
}

TEST_F(V4l2OpenTest, ANodeWithoutPicturesIsNoCamera) {
  driver_.capabilities = V4L2_CAP_META_CAPTURE;
  EXPECT_EQ(refusal().code, ErrorCode::kNoSuchFormat);
}

TEST_F(V4l2OpenTest, ACameraThatGoesWhileItIsAskedIsAMissingDevice) {
  EXPECT_EQ(code_when(VIDIOC_QUERYCAP, -ENODEV), ErrorCode::kDeviceMissing);
  EXPECT_EQ(code_when(VIDIOC_STREAMON, -ESHUTDOWN), ErrorCode::kDeviceMissing);
}

TEST_F(V4l2OpenTest, ACameraInUseSaysWhoseFaultItIs) {
  driver_.failures[VIDIOC_REQBUFS] = -EBUSY;
  EXPECT_THAT(refusal().message, AllOf(HasSubstr("right (usb 1-2"), HasSubstr("another program")));
}

/// Without a transfer mode that is fast enough uvcvideo gives EIO, not ENOSPC.
TEST_F(V4l2OpenTest, AStreamThatCannotStartSaysThatItMayBeTooFast) {
  driver_.failures[VIDIOC_STREAMON] = -EIO;
  EXPECT_THAT(refusal().message, AllOf(HasSubstr("start streaming"), HasSubstr("ask for less")));
}

TEST_F(V4l2OpenTest, AFullBusIsExplainedInNumbers) {
  driver_.failures[VIDIOC_STREAMON] = -ENOSPC;
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kNoBandwidth);
  EXPECT_THAT(error.message, AllOf(HasSubstr("right (usb 1-2"), HasSubstr("18.4 MB/s")));
}

TEST_F(V4l2OpenTest, EachStepKeepsTheDriversReason) {
  EXPECT_EQ(code_when(VIDIOC_S_FMT, -ENODEV), ErrorCode::kDeviceMissing);
  EXPECT_EQ(code_when(VIDIOC_S_PARM, -EIO), ErrorCode::kDeviceFault);
  EXPECT_EQ(code_when(VIDIOC_REQBUFS, -EBUSY), ErrorCode::kDeviceBusy);
  EXPECT_EQ(code_when(VIDIOC_QUERYBUF, -EINVAL), ErrorCode::kDeviceFault);
  EXPECT_EQ(code_when(VIDIOC_QBUF, -ENODEV), ErrorCode::kDeviceMissing);
  EXPECT_EQ(code_when(VIDIOC_STREAMON, -EIO), ErrorCode::kDeviceFault);
}

TEST_F(V4l2OpenTest, TwoBuffersAreEnoughAndOneIsNot) {
  driver_.buffers_given = 2;
  EXPECT_TRUE(V4l2Camera::open(settings_, driver_, clock_));
  driver_.buffers_given = 1;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceFault);
}

TEST_F(V4l2OpenTest, MemoryThatCannotBeMappedIsAFault) {
  driver_.map_fails = true;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceFault);
}

TEST_F(V4l2OpenTest, ARefusedControlIsHandedOn) {
  driver_.controls[V4L2_CID_GAIN].stuck = true;
  EXPECT_EQ(refusal().code, ErrorCode::kControlRefused);
}

}  // namespace
}  // namespace tripoint
