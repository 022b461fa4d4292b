#include "devices/v4l2_format.h"

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

class V4l2FormatTest : public testing::Test {
 protected:
  Result<V4l2Format> set() {
    const auto device = V4l2Device::open(driver_, "/dev/video7", "left (usb 1-1)");
    EXPECT_TRUE(device);
    return set_format(*device, settings_);
  }

  test::WaitingClock clock_;
  test::FakeV4l2Driver driver_{clock_};
  V4l2Settings settings_;
};

TEST_F(V4l2FormatTest, StrideAndRateAreTheDriversOwn) {
  driver_.padding_bytes = 64;
  const auto format = set();
  ASSERT_TRUE(format) << format.error().message;
  EXPECT_EQ(format->stride_bytes, 640U * 2U + 64U);
  EXPECT_NEAR(format->rate_hz, 30.0, 0.001);
}

TEST_F(V4l2FormatTest, MjpegHasNoStride) {
  driver_.fourcc = V4L2_PIX_FMT_MJPEG;
  settings_.format = PixelFormat::kMjpeg;
  const auto format = set();
  ASSERT_TRUE(format) << format.error().message;
  EXPECT_EQ(format->stride_bytes, 0U);
}

TEST_F(V4l2FormatTest, AnotherSizeIsRefusedWithWhatIsOffered) {
  settings_.size = {1280, 720};
  const auto format = set();
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().code, ErrorCode::kNoSuchFormat);
  EXPECT_THAT(format.error().message, AllOf(HasSubstr("YUYV 1280x720"), HasSubstr("offers: YUYV 640x480 at 30 Hz")));
}

TEST_F(V4l2FormatTest, AnotherPixelFormatIsRefused) {
  settings_.format = PixelFormat::kGrey;
  EXPECT_EQ(set().error().code, ErrorCode::kNoSuchFormat);
}

TEST_F(V4l2FormatTest, ARateWithinTwoPercentIsTheRate) {
  settings_.rate_hz = 30.5;
  EXPECT_TRUE(set());
  settings_.rate_hz = 30.7;  // 30 is 2.3 % less
  EXPECT_EQ(set().error().code, ErrorCode::kNoSuchFormat);
}

TEST_F(V4l2FormatTest, ABusyCameraIsSaidToBeBusy) {
  driver_.failures[VIDIOC_S_FMT] = -EBUSY;
  EXPECT_EQ(set().error().code, ErrorCode::kDeviceBusy);
}

TEST_F(V4l2FormatTest, OffersListFormatSizeAndRate) {
  const auto device = V4l2Device::open(driver_, "/dev/video7", "x");
  EXPECT_THAT(formats_offered(*device), ElementsAre("YUYV 640x480 at 30 Hz"));
}

TEST_F(V4l2FormatTest, OnlyANodeThatStreamsPicturesCaptures) {
  const auto device = V4l2Device::open(driver_, "/dev/video7", "x");
  EXPECT_TRUE(captures(*device).value());
  driver_.capabilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  EXPECT_FALSE(captures(*device).value());
  driver_.failures[VIDIOC_QUERYCAP] = -ENOTTY;
  EXPECT_FALSE(captures(*device).value());
}

TEST_F(V4l2FormatTest, ADriverThatKnowsNeitherFormatNorRateOffersWhatItHas) {
  for (const unsigned long request : {VIDIOC_S_FMT, VIDIOC_S_PARM}) {
    for (const int refusal : {-EINVAL, -ENOTTY}) {
      driver_.failures = {{request, refusal}};
      const auto format = set();
      ASSERT_FALSE(format);
      EXPECT_EQ(format.error().code, ErrorCode::kNoSuchFormat);
      EXPECT_THAT(format.error().message, HasSubstr("offers: YUYV 640x480"));
    }
  }
}

/// Half of the rows of such a picture are exposed at another time than the other half.
TEST_F(V4l2FormatTest, InterlacedPicturesAreRefused) {
  driver_.field = V4L2_FIELD_INTERLACED;
  EXPECT_THAT(set().error().message, HasSubstr("interlaced"));
}

TEST(BandwidthTest, TheLoadOfUnpackedPicturesIsComputed) {
  // 640 x 480 x 2 bytes x 30 /s = 18.432 MB/s
  EXPECT_THAT(bandwidth_explained({}), AllOf(HasSubstr("18.4 MB/s"), HasSubstr("36.9 MB/s"), HasSubstr("24 MB/s")));
}

TEST(BandwidthTest, MjpegAsksForAnotherPortOrSize) {
  EXPECT_THAT(bandwidth_explained({.format = PixelFormat::kMjpeg}), HasSubstr("different USB controllers"));
}

}  // namespace
}  // namespace tripoint
