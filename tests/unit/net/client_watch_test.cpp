#include "net/client_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using testing::HasSubstr;

constexpr TimePoint kStart = time_from_ns(7'000'000'000);

TEST(ClientWatchTest, ClientsThatComeAskAndGoAreNoNews) {
  ClientWatch watch;
  EXPECT_FALSE(watch.news({}, kStart));
  EXPECT_FALSE(watch.news({.accepted = 9, .requests = 1000, .connected = 3}, kStart));
}

TEST(ClientWatchTest, TheFirstOfEachKindIsSaidAtOnceWithAllCountsAndWhatToCheck) {
  const ModbusCounters refused{.refused = 3, .displaced = 1, .timed_out = 4, .broken = 15, .connected = 2};
  const auto news = ClientWatch{}.news(refused, kStart);
  ASSERT_TRUE(news);
  EXPECT_THAT(*news, HasSubstr("2 connected; since the start 3 refused, 1 displaced by newcomers, 4 silent or slow, "
                               "15 not speaking Modbus TCP, 0 failures of the system"));
  EXPECT_THAT(*news, HasSubstr("modbus.max_connections"));
  EXPECT_THAT(*news, HasSubstr("modbus.allowed_clients"));
  for (const ModbusCounters& one :
       {ModbusCounters{.refused = 1}, ModbusCounters{.displaced = 1}, ModbusCounters{.timed_out = 1},
        ModbusCounters{.broken = 1}, ModbusCounters{.internal = 1}}) {
    EXPECT_TRUE(ClientWatch{}.news(one, kStart));
  }
}

TEST(ClientWatchTest, WhatComesDuringThePauseIsSaidAfterItInOneLine) {
  ClientWatch watch;
  ASSERT_TRUE(watch.news({.refused = 1}, kStart));
  for (std::uint64_t refused = 2; refused < 100; ++refused) {
    EXPECT_FALSE(watch.news({.refused = refused}, kStart + ClientWatch::kPause - Duration{1})) << refused;
  }
  const auto news = watch.news({.refused = 100}, kStart + ClientWatch::kPause);
  ASSERT_TRUE(news);
  EXPECT_THAT(*news, HasSubstr("100 refused"));
  EXPECT_FALSE(watch.news({.refused = 100}, kStart + 2 * ClientWatch::kPause));
}

}  // namespace
}  // namespace tripoint
