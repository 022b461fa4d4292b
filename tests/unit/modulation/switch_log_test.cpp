#include "modulation/switch_log.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TimePoint at_ms(int ms) { return TimePoint{std::chrono::milliseconds(ms)}; }
constexpr LitLeds kOne = LitLeds::first(1);

TEST(SwitchLogTest, NothingIsKnownBeforeTheFirstSwitching) {
  SwitchLog log;
  EXPECT_FALSE(log.during(at_ms(0), at_ms(1)));
  log.begin(at_ms(10));
  log.complete(at_ms(11), kOne);
  EXPECT_FALSE(log.during(at_ms(5), at_ms(12)));
  EXPECT_EQ(log.during(at_ms(11), at_ms(12)), kOne);
}

TEST(SwitchLogTest, ATimeThatTouchesASwitchingIsNotClear) {
  SwitchLog log;
  log.begin(at_ms(0));
  log.complete(at_ms(1), kOne);
  log.begin(at_ms(30));
  EXPECT_EQ(log.during(at_ms(2), at_ms(30)), kOne);
  EXPECT_FALSE(log.during(at_ms(2), at_ms(31))) << "begun and not completed";
  log.complete(at_ms(33), LitLeds{});
  EXPECT_FALSE(log.during(at_ms(31), at_ms(32)));
  EXPECT_FALSE(log.during(at_ms(29), at_ms(34)));
  EXPECT_EQ(log.during(at_ms(33), at_ms(40)), LitLeds{});
  EXPECT_EQ(log.during(at_ms(2), at_ms(30)), kOne);
}

TEST(SwitchLogTest, AFailedSwitchingLeavesNothingKnown) {
  SwitchLog log;
  log.begin(at_ms(0));
  log.complete(at_ms(1), std::nullopt);
  EXPECT_FALSE(log.during(at_ms(2), at_ms(3)));
}

TEST(SwitchLogTest, WhatLiesTooFarBackIsNotKnown) {
  SwitchLog log;
  for (int i = 0; i < 100; ++i) {
    log.begin(at_ms(10 * i));
    log.complete(at_ms(10 * i), i % 2 == 0 ? kOne : LitLeds{});
  }
  EXPECT_FALSE(log.during(at_ms(1), at_ms(2)));
  EXPECT_EQ(log.during(at_ms(981), at_ms(982)), kOne);
}

}  // namespace
}  // namespace tripoint
