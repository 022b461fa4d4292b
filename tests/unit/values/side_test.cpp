#include "values/side.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(SideTest, TheOtherOfTheOtherIsTheSame) {
  for (const Side side : kBothSides) {
    EXPECT_NE(other(side), side);
    EXPECT_EQ(other(other(side)), side);
  }
}

TEST(SideTest, NamesAreThoseOfTheConfiguration) {
  EXPECT_EQ(name(Side::kLeft), "left");
  EXPECT_EQ(name(Side::kRight), "right");
}

TEST(PerSideTest, EachSideHasItsOwnValue) {
  PerSide<int> values{1, 2};
  EXPECT_EQ(values[Side::kLeft], 1);
  EXPECT_EQ(values[Side::kRight], 2);
  values[Side::kRight] = 5;
  EXPECT_EQ(values.left, 1);
  EXPECT_EQ(values.right, 5);
  EXPECT_EQ(values, (PerSide<int>{1, 5}));
}

}  // namespace
}  // namespace tripoint
