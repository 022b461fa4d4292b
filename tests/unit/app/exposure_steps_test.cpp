#include "app/exposure_steps.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using std::chrono::microseconds;
using ::testing::ElementsAre;

constexpr ExposureOffer kOffered{microseconds{100}, microseconds{33'000}, GainRange{0, 255, 1}};

TEST(ExposureStepsTest, ExposuresAroundAStartReachBothEndsOfWhatIsOffered) {
  EXPECT_THAT(exposures_around(kOffered, microseconds{2000}),
              ElementsAre(microseconds{2000}, microseconds{500}, microseconds{8000}, microseconds{125},
                          microseconds{32'000}, microseconds{100}, microseconds{33'000}));
  EXPECT_THAT(exposures_around({microseconds{50}, microseconds{50}, {}}, microseconds{50}),
              ElementsAre(microseconds{50}));
}

TEST(ExposureStepsTest, WhatIsWantedIsRoundedIntoWhatIsOffered) {
  EXPECT_EQ(exposure_within(kOffered, 99.0), microseconds{100});
  EXPECT_EQ(exposure_within(kOffered, 100.6), microseconds{101});
  EXPECT_EQ(exposure_within(kOffered, 1e9), microseconds{33'000});
}

TEST(ExposureStepsTest, BetweenTooShortAndTooLongItGoesToTheMiddle) {
  ExposureBracket bracket;
  EXPECT_DOUBLE_EQ(bracket.next_us(1000.0, 4.0), 4000.0);
  EXPECT_DOUBLE_EQ(bracket.next_us(4000.0, 0.9), 2000.0);
  EXPECT_DOUBLE_EQ(bracket.next_us(2000.0, 0.9), std::sqrt(1000.0 * 2000.0));
}

}  // namespace
}  // namespace tripoint
