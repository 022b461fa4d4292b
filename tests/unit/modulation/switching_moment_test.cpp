#include "modulation/switching_moment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tripoint {
namespace {

constexpr Duration kPeriod{33'000'000};

TimePoint at_us(int us) { return TimePoint{std::chrono::microseconds(us)}; }
Rhythm rhythm(int middle_us, int half_us) { return {at_us(middle_us), kPeriod, std::chrono::microseconds(half_us)}; }

/// From a moment to the nearest end of an exposure; below 0 inside one.
double to_exposure_us(TimePoint moment, const Rhythm& camera) {
  const double period_us = 1e6 * seconds(camera.period);
  const double off_us = std::remainder(1e6 * seconds(moment - camera.middle), period_us);
  return std::abs(off_us) - 1e6 * seconds(camera.half);
}

TEST(SwitchingMomentTest, OneCameraLeavesTheMiddleBetweenItsExposures) {
  const SwitchingMoment moment = switching_moment(at_us(100'000), {rhythm(0, 2000), std::nullopt});
  EXPECT_EQ(moment.at,
            at_us(148'500));  // 4.5 periods; the usual moment is 133 ms, half a period to each side permitted
  EXPECT_EQ(moment.clearance, std::chrono::microseconds(14'500));
}

TEST(SwitchingMomentTest, ItLiesClearOfBothCamerasAtEveryPhase) {
  for (int phase_us = 0; phase_us < 33'000; phase_us += 500) {
    const PerSide<std::optional<Rhythm>> rhythms{rhythm(200, 4000), rhythm(200 + phase_us, 3000)};
    TimePoint previous = at_us(50'000);
    for (int step = 0; step < 4; ++step) {
      const SwitchingMoment moment = switching_moment(previous, rhythms);
      const double clear_us =
          std::min(to_exposure_us(moment.at, *rhythms.left), to_exposure_us(moment.at, *rhythms.right));
      EXPECT_NEAR(clear_us, 1e6 * seconds(moment.clearance), 0.01) << phase_us;
      EXPECT_GE(clear_us, (33'000.0 - 14'000.0) / 8.0)
          << phase_us;  // the longest of two pauses, halved for being usual
      EXPECT_LE(std::abs(seconds(moment.at - previous - kPeriod)), 0.5 * seconds(kPeriod) + 1e-9);
      previous = moment.at;
    }
  }
}

TEST(SwitchingMomentTest, AUsualMomentIsKept) {
  // Pauses of 17 ms and 8 ms: the moment in the shorter one is left only when it is less than half as long.
  const PerSide<std::optional<Rhythm>> rhythms{rhythm(0, 2000), rhythm(12'000, 2000)};
  const SwitchingMoment longer = switching_moment(at_us(22'500), rhythms);
  EXPECT_EQ(longer.at, at_us(55'500));
  const SwitchingMoment left = switching_moment(at_us(6000), rhythms);
  EXPECT_EQ(left.at, at_us(22'500)) << "a pause of 8 ms, less than half of 17";
  const PerSide<std::optional<Rhythm>> even{rhythm(0, 2000), rhythm(15'000, 2000)};
  EXPECT_EQ(switching_moment(at_us(7500), even).at, at_us(40'500));
}

TEST(SwitchingMomentTest, WithoutAPauseItWandersAndSaysSo) {
  const PerSide<std::optional<Rhythm>> rhythms{rhythm(0, 9000), rhythm(16'500, 9000)};
  const SwitchingMoment moment = switching_moment(at_us(100'000), rhythms);
  EXPECT_LE(moment.clearance, Duration{0});
  EXPECT_EQ(moment.at, at_us(136'300));
}

}  // namespace
}  // namespace tripoint
