#include "values/fixed_vector.h"

#include <numeric>
#include <string>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(FixedVectorTest, HoldsValuesInTheirOrder) {
  FixedVector<int, 4> values;
  EXPECT_TRUE(values.empty());
  for (const int value : {3, 1, 2}) values.push_back(value);
  EXPECT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0], 3);
  EXPECT_EQ(values.back(), 2);
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0), 6);
}

TEST(FixedVectorTest, AFullOneTakesNothingMore) {
  FixedVector<int, 2> values;
  EXPECT_TRUE(values.try_push_back(1));
  EXPECT_FALSE(values.full());
  EXPECT_TRUE(values.try_push_back(2));
  EXPECT_TRUE(values.full());
  EXPECT_FALSE(values.try_push_back(3));
  EXPECT_EQ(values.size(), 2U);
  EXPECT_EQ(values.back(), 2);
}

TEST(FixedVectorTest, TruncateKeepsTheFirst) {
  FixedVector<std::string, 3> values;
  values.push_back("a");
  values.push_back("b");
  values.truncate(1);
  EXPECT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0], "a");
  values.clear();
  EXPECT_TRUE(values.empty());
}

TEST(FixedVectorDeathTest, WhatIsNotThereIsABug) {
  FixedVector<int, 2> values;
  values.push_back(1);
  EXPECT_DEATH(values[1], "bug");
  EXPECT_DEATH(values.truncate(2), "bug");
  values.push_back(2);
  EXPECT_DEATH(values.push_back(3), "bug");
}

TEST(FixedVectorTest, IsUsableInConstantExpressions) {
  constexpr auto kThree = [] {
    FixedVector<int, 3> values;
    values.push_back(3);
    return values;
  }();
  static_assert(kThree.size() == 1 && kThree[0] == 3 && kThree.capacity() == 3);
  EXPECT_EQ(kThree.size(), 1U);
}

}  // namespace
}  // namespace tripoint
