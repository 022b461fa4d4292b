#include "modulation/blink_watch.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace tripoint {
namespace {

TimePoint at_ms(int ms) { return TimePoint{std::chrono::milliseconds(ms)}; }

FixedVector<SpotVerdict, kMaxImagePoints> verdicts(std::initializer_list<SpotVerdict> all) {
  FixedVector<SpotVerdict, kMaxImagePoints> list;
  for (const SpotVerdict verdict : all) list.push_back(verdict);
  return list;
}

TEST(BlinkWatchTest, SaysOnceWhatShinesOnAfterASecondWithoutAnLed) {
  BlinkWatch watch;
  const auto lamps = verdicts({SpotVerdict::kAmbient, SpotVerdict::kUnproven, SpotVerdict::kAmbient});
  EXPECT_FALSE(watch.news(lamps, at_ms(5000)));
  EXPECT_FALSE(watch.news(lamps, at_ms(5999)));
  const auto news = watch.news(lamps, at_ms(6000));
  ASSERT_TRUE(news);
  EXPECT_NE(news->find("2 red lights shine on"), std::string::npos) << *news;
  EXPECT_NE(news->find("check its line"), std::string::npos) << *news;
  EXPECT_FALSE(watch.news(lamps, at_ms(9000)));
}

TEST(BlinkWatchTest, SaysWhenNothingShinesAtAll) {
  BlinkWatch watch;
  EXPECT_FALSE(watch.news({}, at_ms(0)));
  const auto news = watch.news({}, at_ms(1000));
  ASSERT_TRUE(news);
  EXPECT_NE(news->find("no red light shines on"), std::string::npos) << *news;
}

TEST(BlinkWatchTest, AnLedInBetweenIsEnough) {
  BlinkWatch watch;
  for (int ms = 0; ms <= 5000; ms += 500) {
    EXPECT_FALSE(watch.news(ms % 1000 == 0 ? verdicts({SpotVerdict::kLed}) : verdicts({}), at_ms(ms))) << ms;
  }
}

TEST(BlinkWatchTest, SaysOnceThatItIsOver) {
  BlinkWatch watch;
  watch.news({}, at_ms(0));
  ASSERT_TRUE(watch.news({}, at_ms(1000)));
  EXPECT_EQ(watch.news(verdicts({SpotVerdict::kLed}), at_ms(1100)), "LEDs blink again");
  EXPECT_FALSE(watch.news(verdicts({SpotVerdict::kLed}), at_ms(1200)));
}

}  // namespace
}  // namespace tripoint
