#include "values/bounded_queue.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

using namespace std::chrono_literals;

TEST(BoundedQueueTest, GivesValuesInTheirOrder) {
  BoundedQueue<int> queue(3);
  for (const int value : {1, 2, 3}) queue.push(value);
  for (const int value : {1, 2, 3}) EXPECT_EQ(queue.pop(0ns), value);
  EXPECT_EQ(queue.dropped(), 0U);
}

TEST(BoundedQueueTest, AnEmptyOneGivesNothingWithinTheLimit) {
  BoundedQueue<int> queue(3);
  EXPECT_FALSE(queue.pop(0ns));
  EXPECT_FALSE(queue.pop(1ms));
}

TEST(BoundedQueueTest, WhenFullTheOldestGivesWayAndIsCounted) {
  BoundedQueue<int> queue(2);
  for (const int value : {1, 2, 3, 4, 5}) queue.push(value);
  EXPECT_EQ(queue.dropped(), 3U);
  EXPECT_EQ(queue.pop(0ns), 4);
  EXPECT_EQ(queue.pop(0ns), 5);
  EXPECT_FALSE(queue.pop(0ns));
}

TEST(BoundedQueueTest, GoesRoundManyTimes) {
  BoundedQueue<int> queue(3);
  for (int value = 0; value < 100; ++value) {
    queue.push(value);
    queue.push(-value);
    EXPECT_EQ(queue.pop(0ns), value);
    EXPECT_EQ(queue.pop(0ns), -value);
  }
}

TEST(BoundedQueueDeathTest, NoRoomAtAllIsABug) { EXPECT_DEATH(BoundedQueue<int>(0), "bug"); }

TEST(BoundedQueueTest, AWaitingReaderIsWoken) {
  BoundedQueue<int> queue(1);
  std::jthread writer([&] { queue.push(7); });
  EXPECT_EQ(queue.pop(10s), 7);
}

TEST(BoundedQueueTest, TwoWritersLoseNothingUncountedAndKeepTheirOrder) {
  constexpr int kEach = 20'000;
  BoundedQueue<int> queue(16);
  std::atomic<int> writing{2};
  const auto write = [&](int sign) {
    for (int value = 1; value <= kEach; ++value) queue.push(sign * value);
    --writing;
  };
  std::jthread ups(write, 1);
  std::jthread downs(write, -1);
  int up = 0;
  int down = 0;
  std::uint64_t taken = 0;
  for (;;) {
    const bool last_round = writing == 0;
    const auto value = queue.pop(1ms);
    if (!value && last_round) break;
    if (!value) continue;
    ++taken;
    int& newest = *value > 0 ? up : down;
    ASSERT_GT(std::abs(*value), std::abs(newest));
    newest = *value;
  }
  EXPECT_EQ(taken + queue.dropped(), 2U * kEach);
}

}  // namespace
}  // namespace tripoint
