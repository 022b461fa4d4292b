#include "devices/system_clock.h"

#include <gtest/gtest.h>

#include <chrono>

namespace tripoint {
namespace {

using namespace std::chrono_literals;

TEST(SystemClockTest, IsTheClockOfTheStandardLibraryAndOfTheDrivers) {
  const SystemClock clock;
  const auto before = std::chrono::steady_clock::now();
  const TimePoint now = clock.now();
  const auto after = std::chrono::steady_clock::now();
  EXPECT_LE(before, now);
  EXPECT_LE(now, after);
}

TEST(SystemClockTest, TheOffsetLeadsToUtc) {
  const SystemClock clock;
  const auto utc = std::chrono::system_clock::now().time_since_epoch();
  const auto ours = clock.now().time_since_epoch() + clock.utc_offset();
  EXPECT_LT(std::chrono::abs(ours - utc), 1s);  // between two readings a loaded machine may pause
}

}  // namespace
}  // namespace tripoint
