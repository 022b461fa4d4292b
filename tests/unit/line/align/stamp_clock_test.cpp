#include "line/align/stamp_clock.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr double kPeriod_s = 1.0 / 30.0 * (1.0 + 40e-6);

TimePoint at(double time_s) { return TimePoint{duration_from_seconds(time_s)}; }
double true_s(std::uint32_t frame) { return 5.0 + (frame - 100.0) * kPeriod_s; }

struct Errors {
  double rms_s = 0.0;
  double stated_s = 0.0;
  double rms_sigmas = 0.0;
};

/// Error of the newest picture's time after so many, over many runs.
Errors errors_after(std::uint32_t pictures, double jitter_s, double drop_share, double outlier_share) {
  constexpr int kRuns = 300;
  Errors errors;
  for (int run = 0; run < kRuns; ++run) {
    std::mt19937_64 random(static_cast<std::uint64_t>(run));
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    StampClock clock;
    std::uint32_t newest = 0;
    for (std::uint32_t frame = 100; frame < 100 + pictures; ++frame) {
      if (uniform(random) < drop_share) continue;
      const double late_s = uniform(random) < outlier_share ? 0.02 + 0.04 * uniform(random) : 0.0;
      clock.take(frame, at(true_s(frame) + jitter_s * normal(random) + late_s));
      newest = frame;
    }
    const double error_s = seconds(clock.time_of(newest).time_since_epoch()) - true_s(newest);
    errors.rms_s += error_s * error_s / kRuns;
    errors.stated_s += clock.sigma_s() * clock.sigma_s() / kRuns;
    errors.rms_sigmas += error_s * error_s / (clock.sigma_s() * clock.sigma_s()) / kRuns;
  }
  return {std::sqrt(errors.rms_s), std::sqrt(errors.stated_s), std::sqrt(errors.rms_sigmas)};
}

TEST(StampClockTest, JitterAveragesOutAsInAStraightLineFit) {
  for (const std::uint32_t pictures : {90U, 300U, 900U}) {
    const Errors errors = errors_after(pictures, 3e-3, 0.0, 0.0);
    // the newest end of a least-squares line: 2 sigma / sqrt(n); 15 % for 300 runs (4 %, three times) and what the
    // medians of the start and Huber's weights cost
    EXPECT_NEAR(errors.rms_s, 2.0 * 3e-3 / std::sqrt(pictures), 0.15 * 2.0 * 3e-3 / std::sqrt(pictures)) << pictures;
    EXPECT_NEAR(errors.rms_sigmas, 1.0, 0.12) << pictures;
  }
}

TEST(StampClockTest, DroppedPicturesAndLateStampsDoNotShiftIt) {
  const Errors errors = errors_after(900, 3e-3, 0.02, 0.005);
  EXPECT_LT(errors.rms_s, 1.15 * 2.0 * 3e-3 / std::sqrt(882.0));
  EXPECT_NEAR(errors.rms_sigmas, 1.0, 0.12);
}

TEST(StampClockTest, SteadyStampsAreFollowedClosely) { EXPECT_LT(errors_after(300, 0.1e-3, 0.0, 0.0).rms_s, 0.02e-3); }

TEST(StampClockTest, TheFirstStampIsItsOwnTime) {
  StampClock clock;
  EXPECT_FALSE(clock.started());
  clock.take(7, at(3.25));
  EXPECT_TRUE(clock.started());
  EXPECT_EQ(clock.time_of(7), at(3.25));
  EXPECT_EQ(clock.period(), Duration{0});
  EXPECT_GT(clock.sigma_s(), 3e-3);
}

TEST(StampClockTest, AGapInTheNumbersIsTimeThatPassed) {
  StampClock clock;
  for (const std::uint32_t frame : {0U, 1U, 2U, 5U, 6U, 7U, 8U, 9U, 10U, 14U}) clock.take(frame, at(frame / 30.0));
  EXPECT_NEAR(seconds(clock.time_of(12).time_since_epoch()), 12.0 / 30.0, 1e-8);
  EXPECT_NEAR(seconds(clock.period()), 1.0 / 30.0, 2e-9);  // a Duration is whole nanoseconds
}

TEST(StampClockTest, NumbersMayWrapAround) {
  StampClock clock;
  std::uint32_t frame = std::numeric_limits<std::uint32_t>::max() - 20;
  for (int i = 0; i < 60; ++i, ++frame) clock.take(frame, at(1.0 + i / 30.0));
  EXPECT_NEAR(seconds(clock.time_of(frame - 1).time_since_epoch()), 1.0 + 59.0 / 30.0, 1e-6);
}

TEST(StampClockTest, ARestartOfTheNumbersStartsAnew) {
  StampClock clock;
  for (std::uint32_t frame = 0; frame < 60; ++frame) clock.take(frame, at(1.0 + frame / 30.0));
  const double settled_s = clock.sigma_s();
  clock.take(0, at(4.0));
  EXPECT_EQ(clock.time_of(0), at(4.0));
  EXPECT_GT(clock.sigma_s(), 3.0 * settled_s);
}

TEST(StampClockTest, AStepIsDoubtedAtOnceAndBelievedAfterFourStamps) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  StampClock clock;
  std::uint32_t frame = 0;
  const auto take = [&](double step_s) {
    clock.take(frame, at(1.0 + frame / 30.0 + step_s + 1e-3 * normal(random)));
    ++frame;
  };
  while (frame < 300) take(0.0);
  take(0.010);
  EXPECT_LT(clock.sigma_s(), 0.5e-3) << "one stamp late by less than half a period is an outlier";
  take(0.010);
  EXPECT_GT(clock.sigma_s(), 7e-3) << "two are a doubt";
  take(0.010);
  take(0.010);
  // four stamps of 1 ms jitter: their median is good to 1.25 ms / 2
  EXPECT_NEAR(seconds(clock.time_of(frame - 1).time_since_epoch()), 1.0 + (frame - 1) / 30.0 + 0.010, 2.5e-3);
  EXPECT_NEAR(seconds(clock.period()), 1.0 / 30.0, 1e-5) << "the period known before is kept";
}

TEST(StampClockTest, OneStampLateByAFrameIsADoubtAtOnce) {
  StampClock clock;
  for (std::uint32_t frame = 0; frame < 300; ++frame) clock.take(frame, at(1.0 + frame / 30.0));
  clock.take(300, at(1.0 + 301.0 / 30.0));  // the bus lost a picture and the driver did not number it
  EXPECT_GT(clock.sigma_s(), 30e-3);
}

TEST(StampClockTest, ASmallLastingStepIsFoundByItsDrift) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  StampClock clock;
  for (std::uint32_t frame = 0; frame < 1000; ++frame) {
    const double step_s = frame < 600 ? 0.0 : 8e-3;  // 2.7 sigma: below the gate for single stamps
    clock.take(frame, at(1.0 + frame / 30.0 + step_s + 3e-3 * normal(random)));
  }
  EXPECT_NEAR(seconds(clock.time_of(999).time_since_epoch()), 1.0 + 999 / 30.0 + 8e-3, 4.0 * clock.sigma_s());
  EXPECT_LT(clock.sigma_s(), 0.6e-3);
}

}  // namespace
}  // namespace tripoint
