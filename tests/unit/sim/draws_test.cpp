#include "sim/draws.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr int kCount = 20'000;

TEST(DrawsTest, SameSeedAndTopicGiveTheSameDrawsAndOthersDoNot) {
  Draws one(7, 3);
  Draws same(7, 3);
  Draws other_topic(7, 4);
  Draws other_seed(8, 3);
  const double first = one.even(0.0, 1.0);
  EXPECT_EQ(first, same.even(0.0, 1.0));
  EXPECT_NE(first, other_topic.even(0.0, 1.0));
  EXPECT_NE(first, other_seed.even(0.0, 1.0));
}

// Vigna's splitmix64.c seeded with 0 gives e220a8397b1dcdaf first; the draw is its upper 53 bits.
TEST(DrawsTest, BitsAreThoseOfThePublishedGenerator) { EXPECT_EQ(mixed(0), 0xE220A8397B1DCDAFULL); }

TEST(DrawsTest, EvenDrawsFillTheirRangeEvenly) {
  Draws draws(1, 0);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double value = draws.even(2.0, 5.0);
    ASSERT_GE(value, 2.0);
    ASSERT_LT(value, 5.0);
    sum += value - 3.5;
    squares += (value - 3.5) * (value - 3.5);
  }
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 * std::sqrt(0.75 / kCount));       // variance 9/12
  EXPECT_NEAR(squares / kCount, 0.75, 5.0 * std::sqrt(0.45 / kCount));  // its own variance is 81/180
}

TEST(DrawsTest, FirstDrawsOfSeedsInARowAreEven) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < kCount; ++seed) sum += Draws(seed, 5).even(-1.0, 1.0);
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 * std::sqrt(1.0 / 3.0 / kCount));
}

TEST(DrawsTest, ScaledDrawsAreEvenInTheLogarithm) {
  Draws draws(2, 0);
  int below = 0;
  for (int i = 0; i < kCount; ++i) below += draws.scaled({0.01, 1.0}) < 0.1 ? 1 : 0;
  EXPECT_NEAR(below, 0.5 * kCount, 5.0 * std::sqrt(0.25 * kCount));
  EXPECT_EQ(draws.scaled({0.05, 0.05}), 0.05);
  EXPECT_EQ(draws.scaled({0.0, 0.0}), 0.0);
}

TEST(DrawsTest, ChanceAndIndexHitTheirShares) {
  Draws draws(3, 0);
  int hits = 0;
  std::array<int, 4> counts{};
  for (int i = 0; i < kCount; ++i) {
    hits += draws.chance(0.15) ? 1 : 0;
    ++counts.at(draws.index(4));
  }
  EXPECT_NEAR(hits, 0.15 * kCount, 5.0 * std::sqrt(0.15 * 0.85 * kCount));
  for (const int count : counts) EXPECT_NEAR(count, 0.25 * kCount, 5.0 * std::sqrt(0.1875 * kCount));
}

TEST(DrawsTest, NormalDrawsHaveMeanZeroAndVarianceOne) {
  Draws draws(4, 0);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double value = draws.normal();
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 1.0, 5.0 * std::sqrt(2.0 / kCount));
}

}  // namespace
}  // namespace tripoint
