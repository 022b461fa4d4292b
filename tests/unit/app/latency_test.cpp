#include "app/latency.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

using std::chrono::microseconds;

TEST(LatencyWindowTest, EmptyWindowReadsZero) { EXPECT_EQ(LatencyWindow{}.quantile(0.5), Duration{0}); }

TEST(LatencyWindowTest, QuantilesAreNearestRanks) {
  LatencyWindow window;
  for (int i = 100; i >= 1; --i) window.add(microseconds(i));
  EXPECT_EQ(window.quantile(0.5), microseconds(50));
  EXPECT_EQ(window.quantile(0.99), microseconds(99));
  EXPECT_EQ(window.quantile(1.0), microseconds(100));
  EXPECT_EQ(window.quantile(0.0), microseconds(1));
}

TEST(LatencyWindowTest, OldDurationsAreForgotten) {
  LatencyWindow window;
  window.add(std::chrono::seconds(1));
  for (int i = 0; i < 1024; ++i) window.add(microseconds(7));
  EXPECT_EQ(window.quantile(1.0), microseconds(7));
}

}  // namespace
}  // namespace tripoint
