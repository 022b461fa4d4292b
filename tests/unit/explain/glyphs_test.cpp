#include "explain/glyphs.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tripoint {
namespace {

constexpr int kWidest_units = 4;

TEST(GlyphsTest, EveryStrokeIsMadeOfPairsInsideTheGrid) {
  for (char letter = '!'; letter <= '~'; ++letter) {
    const std::string_view strokes = glyph_of(letter).strokes;
    for (std::size_t i = 0; i < strokes.size(); i += 3) {  // "xy" and ' ' or '|'
      ASSERT_LE(i + 2, strokes.size()) << letter;
      EXPECT_TRUE(strokes[i] >= '0' && strokes[i] <= '0' + kWidest_units) << letter;
      EXPECT_TRUE(strokes[i + 1] >= '0' && strokes[i + 1] <= '0' + kCapHeight_units + kDescender_units) << letter;
      EXPECT_TRUE(i + 2 == strokes.size() || strokes[i + 2] == ' ' || strokes[i + 2] == '|') << letter;
    }
  }
}

TEST(GlyphsTest, NoTwoLettersLookTheSame) {
  std::set<std::string_view> seen;
  for (char letter = ' '; letter <= '~'; ++letter) {
    if (letter == 'O') continue;  // as 0
    EXPECT_TRUE(seen.insert(glyph_of(letter).strokes).second) << letter;
  }
}

TEST(GlyphsTest, WhatIsNotPrintableIsAQuestionMark) {
  for (const char letter : {'\n', '\x7f', '\xc3', '\0'}) EXPECT_EQ(glyph_of(letter).strokes, glyph_of('?').strokes);
}

TEST(GlyphsTest, TheWidthIsThatOfTheLettersAndTheSpacesBetween) {
  EXPECT_EQ(width_units_of(""), 0);
  EXPECT_EQ(width_units_of("H"), 4);
  EXPECT_EQ(width_units_of("HH"), 4 + kLetterSpace_units + 4);
}

}  // namespace
}  // namespace tripoint
