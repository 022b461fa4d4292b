#include "devices/exposure_stamp.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "devices/v4l2_driver.h"
#include "scratch_folder.h"

namespace tripoint {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kStamp = time_from_ns(1'000'000'000);

TEST(ExposureStampTest, TheFirstByteComesWhenTheExposureOfRow0IsOver) {
  EXPECT_EQ(middle_of_exposure(kStamp, StampPoint::kFirstByte, 4ms), kStamp - 2ms);
}

TEST(ExposureStampTest, TheStartIsHalfAnExposureBeforeTheMiddle) {
  EXPECT_EQ(middle_of_exposure(kStamp, StampPoint::kStartOfExposure, 4ms), kStamp + 2ms);
}

/// A system whose uvcvideo has this parameter.
class StampPointTest : public ::testing::Test {
 protected:
  StampPointTest() { std::filesystem::create_directories(parameters()); }

  StampPoint with(const std::string& hwtimestamps) {
    std::ofstream(parameters() / "hwtimestamps") << hwtimestamps;
    return KernelV4l2Driver(sys_.path()).stamp_point();
  }
  [[nodiscard]] std::filesystem::path parameters() const { return sys_ / "module/uvcvideo/parameters"; }

  test::ScratchFolder sys_;
};

TEST_F(StampPointTest, UvcvideoStampsTheFirstByteUnlessToldOtherwise) {
  EXPECT_EQ(KernelV4l2Driver(sys_.path()).stamp_point(), StampPoint::kFirstByte);  // the module has no such parameter
  EXPECT_EQ(with("0\n"), StampPoint::kFirstByte);
}

TEST_F(StampPointTest, WithHardwareStampsItIsTheStartOfTheExposure) {
  EXPECT_EQ(with("1\n"), StampPoint::kStartOfExposure);
}

}  // namespace
}  // namespace tripoint
