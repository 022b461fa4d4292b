#include "devices/v4l2_controls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>

#include "fake_v4l2_driver.h"

namespace tripoint {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class V4l2ControlsTest : public testing::Test {
 protected:
  Result<V4l2Controls> set() {
    const auto device = V4l2Device::open(driver_, "/dev/video7", "left (usb 1-1)");
    EXPECT_TRUE(device);
    return set_controls(*device, settings_);
  }
  Error refusal() {
    const auto controls = set();
    EXPECT_FALSE(controls);
    return controls ? Error{ErrorCode::kDeviceFault} : controls.error();
  }
  int value(std::uint32_t id) { return driver_.controls.at(id).value; }

  test::WaitingClock clock_;
  test::FakeV4l2Driver driver_{clock_};
  V4l2Settings settings_{.exposure = std::chrono::microseconds(2000), .gain = 33, .white_balance_k = 4600, .focus = 5};
};

TEST_F(V4l2ControlsTest, EveryAutomaticIsOffAndEveryValueSet) {
  const auto controls = set();
  ASSERT_TRUE(controls) << controls.error().message;
  EXPECT_EQ(value(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(value(V4L2_CID_EXPOSURE_AUTO_PRIORITY), 0);
  EXPECT_EQ(value(V4L2_CID_EXPOSURE_ABSOLUTE), 20);  // 2000 us in units of 100
  EXPECT_EQ(value(V4L2_CID_GAIN), 33);
  EXPECT_EQ(value(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(value(V4L2_CID_WHITE_BALANCE_TEMPERATURE), 4600);
  EXPECT_EQ(value(V4L2_CID_FOCUS_AUTO), 0);
  EXPECT_EQ(value(V4L2_CID_FOCUS_ABSOLUTE), 5);
}

TEST_F(V4l2ControlsTest, TheExposureIsRoundedToTheCamerasUnit) {
  settings_.exposure = std::chrono::microseconds(2060);
  EXPECT_EQ(set()->exposure, std::chrono::microseconds(2100));
  settings_.exposure = std::chrono::microseconds(10);
  EXPECT_EQ(set()->exposure, std::chrono::microseconds(100));  // the least there is
}

TEST_F(V4l2ControlsTest, TheExposuresThatTheCameraOffersAreTold) {
  const auto controls = set();
  ASSERT_TRUE(controls) << controls.error().message;
  EXPECT_EQ(controls->shortest_exposure, std::chrono::microseconds(100));
  EXPECT_EQ(controls->longest_exposure, std::chrono::milliseconds(500));
}

TEST_F(V4l2ControlsTest, TheGainAndTheGainsThatTheCameraOffersAreTold) {
  driver_.controls[V4L2_CID_GAIN].minimum = 16;
  driver_.controls[V4L2_CID_GAIN].maximum = 128;
  const auto controls = set();
  ASSERT_TRUE(controls) << controls.error().message;
  EXPECT_EQ(controls->gain, 33);
  EXPECT_EQ(controls->gains, (GainRange{16, 128, 1}));
}

TEST_F(V4l2ControlsTest, ACameraWithoutGainTellsNone) {
  driver_.controls.erase(V4L2_CID_GAIN);
  const auto controls = set();
  ASSERT_TRUE(controls) << controls.error().message;
  EXPECT_EQ(controls->gain, std::nullopt);
  EXPECT_EQ(controls->gains, std::nullopt);
}

TEST_F(V4l2ControlsTest, AbsentControlsAreNoted) {
  driver_.controls.erase(V4L2_CID_FOCUS_AUTO);
  driver_.controls.erase(V4L2_CID_FOCUS_ABSOLUTE);
  const auto controls = set();
  ASSERT_TRUE(controls) << controls.error().message;
  EXPECT_THAT(controls->missing, ElementsAre("gain_automatic", "focus_automatic_continuous", "focus_absolute"));
}

TEST_F(V4l2ControlsTest, ACameraWithoutManualExposureIsRefused) {
  driver_.controls.erase(V4L2_CID_EXPOSURE_ABSOLUTE);
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kControlRefused);
  EXPECT_THAT(error.message, HasSubstr("exposure_absolute"));
}

TEST_F(V4l2ControlsTest, AValueThatReadsBackDifferentlyIsRefused) {
  driver_.controls[V4L2_CID_EXPOSURE_ABSOLUTE].stuck = true;
  const Error error = refusal();
  EXPECT_EQ(error.code, ErrorCode::kControlRefused);
  EXPECT_THAT(error.message, AllOf(HasSubstr("left (usb 1-1)"), HasSubstr("exposure_absolute wanted 20, got 157")));
}

TEST_F(V4l2ControlsTest, AValueOutOfRangeNamesTheRange) {
  settings_.gain = 256;
  EXPECT_THAT(refusal().message, HasSubstr("gain wanted 256, got 255; the camera permits 0 to 255"));
}

TEST_F(V4l2ControlsTest, ACameraThatIsNotReadyForAControlRefusesIt) {
  for (const int answer : {-EBUSY, -EACCES, -EILSEQ, -EREMOTE}) {
    driver_.failures = {{VIDIOC_S_CTRL, answer}};
    const Error error = refusal();
    EXPECT_EQ(error.code, ErrorCode::kControlRefused) << error.message;
    EXPECT_THAT(error.message, AllOf(HasSubstr("exposure_auto wanted 1"), Not(HasSubstr("another program"))));
  }
}

TEST_F(V4l2ControlsTest, UnpluggingWhileAskingIsNotAnAbsentControl) {
  driver_.failures[VIDIOC_QUERYCTRL] = -ENODEV;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
}

TEST_F(V4l2ControlsTest, UnpluggingWhileSettingIsAMissingDevice) {
  driver_.failures[VIDIOC_S_CTRL] = -ENODEV;
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceMissing);
  driver_.failures = {{VIDIOC_G_CTRL, -EIO}};
  EXPECT_EQ(refusal().code, ErrorCode::kDeviceFault);
}

}  // namespace
}  // namespace tripoint
