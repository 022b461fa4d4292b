// The letters of an explanation as strokes of a pen. The daemon links no drawing library for them: OpenCV's brings
// 8 MB of resident memory with it, and X11.
#pragma once

#include <string_view>

namespace tripoint {

inline constexpr int kCapHeight_units = 6;  ///< capitals and digits stand in rows 0 to 6
inline constexpr int kDescender_units = 2;  ///< and g, j, p, q, y reach down to row 8
inline constexpr int kLetterSpace_units = 2;

struct Glyph {
  std::string_view strokes;  ///< pairs of digits "xy" (column, row), each to be reached by the pen; '|' lifts it
  int width_units = 0;
};

/// @return the glyph of '?' for what is not printable ASCII
Glyph glyph_of(char letter);

/// From the first stroke to the last, in units.
int width_units_of(std::string_view text);

}  // namespace tripoint
