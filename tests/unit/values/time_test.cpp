#include "values/time.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(TimeTest, NanosecondsSurviveTheWayThereAndBack) {
  for (const std::int64_t ns : {std::int64_t{0}, std::int64_t{-7}, std::int64_t{1'700'000'000'123'456'789}}) {
    EXPECT_EQ(ns_from_time(time_from_ns(ns)), ns);
  }
}

TEST(TimeTest, SecondsAndDurationsAgreeToANanosecond) {
  EXPECT_EQ(seconds(Duration{1'500'000'000}), 1.5);
  EXPECT_EQ(duration_from_seconds(0.25), Duration{250'000'000});
  EXPECT_EQ(duration_from_seconds(-0.25), Duration{-250'000'000});
}

}  // namespace
}  // namespace tripoint
