#include "modulation/blink.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

/// What the light of an LED shows from step 0 on.
Blink shown(const LedCode& code, std::size_t led, std::uint64_t steps) {
  Blink blink(code);
  for (std::uint64_t step = 0; step < steps; ++step) {
    const LitLeds lit = code.lit_in(step);
    lit.contains(led) ? blink.take_seen(lit) : blink.take_dark(lit);
  }
  return blink;
}

TEST(BlinkTest, EachLedIsKnownAfterItsCodeAndNotTakenForAnother) {
  for (std::size_t leds = 1; leds <= kMaxTargetPoints; ++leds) {
    const LedCode code(leds);
    for (std::size_t led = 0; led < leds; ++led) {
      for (std::uint64_t steps = 0; steps < 40; ++steps) {
        const std::optional<std::size_t> known = shown(code, led, steps).led();
        EXPECT_TRUE(!known || *known == led) << led << " of " << leds << " after " << steps;
      }
      EXPECT_EQ(shown(code, led, 40).led(), led) << led << " of " << leds;
    }
  }
}

TEST(BlinkTest, EachLedStaysKnownForAsLongAsItsCodeIsShown) {
  for (std::size_t leds = 1; leds <= kMaxTargetPoints; ++leds) {
    for (std::size_t led = 0; led < leds; ++led) {
      for (std::uint64_t steps = 40; steps < 100; ++steps) {
        EXPECT_EQ(shown(LedCode(leds), led, steps).led(), led) << led << " of " << leds << " after " << steps;
      }
    }
  }
}

TEST(BlinkTest, AnLedThatNobodySwitchesAnyMoreIsNotBelievedForLong) {
  const LedCode code(1);
  Blink blink = shown(code, 0, 10);  // the last step was one in which it is out
  for (int i = 0; i < Blink::kMostSeenInARow; ++i) {
    blink.take_seen(code.all());
    EXPECT_EQ(blink.led(), 0U) << i;
  }
  blink.take_seen(code.all());
  EXPECT_FALSE(blink.led());
  EXPECT_FALSE(blink.none());
  blink.take_dark(LitLeds{});
  EXPECT_EQ(blink.led(), 0U) << "they are switched again";
}

TEST(BlinkTest, ASteadyLightIsNone) {
  const LedCode code(1);
  Blink blink(code);
  blink.take_seen(code.all());
  EXPECT_FALSE(blink.none());
  blink.take_seen(LitLeds{});
  EXPECT_TRUE(blink.none());
  for (int i = 0; i < 10; ++i) blink.take_dark(LitLeds{});
  EXPECT_FALSE(blink.led()) << "what was none once is none for as long as it is followed";
}

TEST(BlinkTest, ALightThatBlinksInEveryOtherPictureIsNone) {
  const LedCode code(1);
  for (std::uint64_t start = 0; start < 5; ++start) {
    Blink blink(code);
    for (std::uint64_t step = start; step < start + 8; ++step) {
      (step - start) % 2 == 0 ? blink.take_seen(code.lit_in(step)) : blink.take_dark(code.lit_in(step));
      EXPECT_FALSE(blink.led()) << start << " " << step;
    }
    EXPECT_TRUE(blink.none()) << start;
  }
}

TEST(BlinkTest, AnLedThatIsMissedWhereItIsLitIsNeverTakenForAnother) {
  const LedCode code(12);
  for (std::size_t led = 0; led < 12; ++led) {
    for (std::uint32_t missed = 0; missed < 64; ++missed) {
      Blink blink(code);
      blink.take_seen(code.all());
      for (std::size_t slot = 0; slot < code.slots().size(); ++slot) {
        const LitLeds lit = code.slots()[slot];
        const bool seen = lit.contains(led) && ((missed >> slot) & 1U) == 0;
        seen ? blink.take_seen(lit) : blink.take_dark(lit);
      }
      EXPECT_TRUE(!blink.led() || *blink.led() == led) << led << " " << missed;
    }
  }
}

TEST(BlinkTest, ItMustHaveBeenDarkTheLastTimeItHadToBe) {
  const LedCode code(1);
  Blink blink = shown(code, 0, 8);
  ASSERT_TRUE(blink.led());
  blink.take_unclear(LitLeds{});
  EXPECT_FALSE(blink.led());
  EXPECT_FALSE(blink.none());
  blink.take_dark(LitLeds{});
  EXPECT_TRUE(blink.led());
}

}  // namespace
}  // namespace tripoint
