#include "capture/frame_rate.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr std::int64_t kPeriod_ns = 40'000'000;  // 25 Hz

TEST(FrameRateTest, IsUnknownUntilASecondIsOver) {
  FrameRate rate;
  for (int i = 0; i < 25; ++i) rate.take(time_from_ns(i * kPeriod_ns));
  EXPECT_EQ(rate.rate_hz(), 0.0);
}

TEST(FrameRateTest, IsFramesOverTime) {
  FrameRate rate;
  for (int i = 0; i <= 25; ++i) rate.take(time_from_ns(i * kPeriod_ns));
  EXPECT_DOUBLE_EQ(rate.rate_hz(), 25.0);
}

TEST(FrameRateTest, FollowsACameraThatSlowsDown) {
  FrameRate rate;
  for (int i = 0; i <= 25; ++i) rate.take(time_from_ns(i * kPeriod_ns));
  for (int i = 1; i <= 5; ++i) rate.take(time_from_ns(25 * kPeriod_ns + i * 5 * kPeriod_ns));
  EXPECT_DOUBLE_EQ(rate.rate_hz(), 5.0);
}

TEST(FrameRateTest, RestartForgets) {
  FrameRate rate;
  for (int i = 0; i <= 25; ++i) rate.take(time_from_ns(i * kPeriod_ns));
  rate.restart();
  EXPECT_EQ(rate.rate_hz(), 0.0);
}

}  // namespace
}  // namespace tripoint
