#include "devices/exposure_stamp.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kStamp = time_from_ns(1'000'000'000);

TEST(ExposureStampTest, TheFirstByteComesWhenTheExposureOfRow0IsOver) {
  EXPECT_EQ(middle_of_exposure(kStamp, {StampPoint::kFirstByte, 4ms, 0ms}), kStamp - 2ms);
}

TEST(ExposureStampTest, TheStartIsHalfAnExposureBeforeTheMiddle) {
  EXPECT_EQ(middle_of_exposure(kStamp, {StampPoint::kStartOfExposure, 4ms, 0ms}), kStamp + 2ms);
}

TEST(ExposureStampTest, LatencyIsTakenOffBoth) {
  EXPECT_EQ(middle_of_exposure(kStamp, {StampPoint::kFirstByte, 4ms, 5ms}), kStamp - 7ms);
  EXPECT_EQ(middle_of_exposure(kStamp, {StampPoint::kStartOfExposure, 4ms, 5ms}), kStamp - 3ms);
}

}  // namespace
}  // namespace tripoint
