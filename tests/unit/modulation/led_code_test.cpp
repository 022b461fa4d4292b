#include "modulation/led_code.h"

#include <gtest/gtest.h>

namespace tripoint {
namespace {

bool lit_in_slot(const LedCode& code, std::size_t led, std::size_t slot) { return code.slots()[slot].contains(led); }

TEST(LedCodeTest, NoCodeIsPartOfAnother) {
  for (std::size_t leds = 2; leds <= kMaxTargetPoints; ++leds) {
    const LedCode code(leds);
    for (std::size_t a = 0; a < leds; ++a) {
      for (std::size_t b = 0; b < leds; ++b) {
        if (a == b) continue;
        bool part = true;
        for (std::size_t slot = 0; slot < code.slots().size(); ++slot) {
          part = part && (!lit_in_slot(code, a, slot) || lit_in_slot(code, b, slot));
        }
        EXPECT_FALSE(part) << a << " of " << b << " among " << leds;
      }
    }
  }
}

TEST(LedCodeTest, EveryLedIsOutInASlot) {
  for (std::size_t leds = 1; leds <= kMaxTargetPoints; ++leds) {
    const LedCode code(leds);
    for (std::size_t led = 0; led < leds; ++led) {
      bool out = false;
      for (const LitLeds slot : code.slots()) out = out || !slot.contains(led);
      EXPECT_TRUE(out) << led << " among " << leds;
    }
  }
}

TEST(LedCodeTest, SlotsAreAsFewAsSpernersTheoremAllows) {
  // The largest of the binomial coefficients of 1 to 6: 1, 2, 3, 6, 10, 20.
  const std::array<std::size_t, 13> slots{0, 1, 2, 3, 4, 4, 4, 5, 5, 5, 5, 6, 6};
  for (std::size_t leds = 1; leds <= kMaxTargetPoints; ++leds) EXPECT_EQ(LedCode(leds).slots().size(), slots[leds]);
}

TEST(LedCodeTest, AllAreLitInThreeOfFiveStepsAndNeverMoreThanTwoApart) {
  const LedCode code(5);
  int all = 0;
  for (std::uint64_t step = 0; step < 50; ++step) {
    all += code.lit_in(step) == code.all() ? 1 : 0;
    EXPECT_TRUE(code.lit_in(step) == code.all() || code.lit_in(step + 1) == code.all()) << step;
  }
  EXPECT_EQ(all, 30);
}

TEST(LedCodeTest, SlotsComeInTurn) {
  const LedCode code(3);
  const std::array<std::uint64_t, 4> steps{1, 4, 6, 9};
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_EQ(code.lit_in(steps[i]), code.slots()[i % 3]);
}

}  // namespace
}  // namespace tripoint
