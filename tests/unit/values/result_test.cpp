#include "values/result.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

Result<int> halved(int value) {
  if (value % 2 != 0) return failure(ErrorCode::kOutOfRange, "odd");
  return value / 2;
}

TEST(ResultTest, IsAValueOrACodeWithALine) {
  EXPECT_EQ(*halved(4), 2);
  const Result<int> refused = halved(3);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(refused.error().message, "odd");
}

TEST(ResultTest, InsideTheLineTheMessageMayStayEmpty) {
  EXPECT_TRUE(Result<int>(failure(ErrorCode::kDegenerate)).error().message.empty());
}

}  // namespace
}  // namespace tripoint
