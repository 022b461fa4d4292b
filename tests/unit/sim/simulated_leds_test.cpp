#include "sim/simulated_leds.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

class SetClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return time; }
  [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
  [[nodiscard]] bool synchronised() const override { return false; }
  TimePoint time{};
};

TimePoint at_ms(int ms) { return TimePoint{std::chrono::milliseconds(ms)}; }

class SimulatedLedsTest : public testing::Test {
 protected:
  void set(std::size_t led, bool lit, int ms) {
    clock_.time = at_ms(ms);
    ASSERT_TRUE(leds_.line(led)->set(lit));
  }
  SetClock clock_;
  SimulatedLeds leds_{clock_};
};

TEST_F(SimulatedLedsTest, AreOutUntilALineIsSet) {
  EXPECT_EQ(leds_.lit_share(0, at_ms(0), at_ms(10)), 0.0);
  set(0, true, 100);
  EXPECT_EQ(leds_.lit_share(0, at_ms(0), at_ms(100)), 0.0);
  EXPECT_EQ(leds_.lit_share(0, at_ms(100), at_ms(200)), 1.0);
  EXPECT_EQ(leds_.lit_share(1, at_ms(100), at_ms(200)), 0.0);
}

TEST_F(SimulatedLedsTest, AShareOfATimeIsThatOfItsLitParts) {
  set(3, true, 100);
  set(3, false, 130);
  set(3, true, 170);
  EXPECT_NEAR(leds_.lit_share(3, at_ms(120), at_ms(180)), 20.0 / 60.0, 1e-12);
  EXPECT_NEAR(leds_.lit_share(3, at_ms(80), at_ms(160)), 30.0 / 80.0, 1e-12);
}

TEST_F(SimulatedLedsTest, AMomentIsLitOrOut) {
  set(0, true, 100);
  set(0, false, 130);
  EXPECT_EQ(leds_.lit_share(0, at_ms(99), at_ms(99)), 0.0);
  EXPECT_EQ(leds_.lit_share(0, at_ms(100), at_ms(100)), 1.0);
  EXPECT_EQ(leds_.lit_share(0, at_ms(130), at_ms(130)), 0.0);
}

TEST_F(SimulatedLedsTest, WhatLiesTooFarBackCountsAsOut) {
  for (int i = 0; i <= 2 * static_cast<int>(SimulatedLeds::kKept); ++i) set(0, true, i);
  EXPECT_EQ(leds_.lit_share(0, at_ms(0), at_ms(10)), 0.0);
  EXPECT_EQ(leds_.lit_share(0, at_ms(200), at_ms(210)), 1.0);
}

}  // namespace
}  // namespace tripoint
