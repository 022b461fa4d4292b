// The pixels of a disc or a ring of a window, row by row.
#pragma once

#include <algorithm>
#include <cmath>

#include "line/detect/spot_window.h"

namespace tripoint {

/// In window coordinates.
struct Disc {
  double column = 0.0;
  double row = 0.0;
  double inner_px = 0.0;  ///< radius of the hole, negative for none
  double outer_px = 0.0;
};

/// Neighbours in one row, first and last column inclusive.
struct Run {
  int row = 0;
  int first = 0;
  int last = 0;
};

/// Half the length of a row's part within a circle, -1 when the row misses it.
inline double half_chord_px(double radius_px, double distance_px) {
  const double rest = radius_px * radius_px - distance_px * distance_px;
  return radius_px < 0.0 || rest < 0.0 ? -1.0 : std::sqrt(rest);
}

/// Calls `see` with each run of pixels of `shown` whose distance is within the disc.
template <typename See>
void for_each_run(const SpotWindow::Part& shown, const Disc& disc, See see) {
  const int top = std::max(shown.top, static_cast<int>(std::ceil(disc.row - disc.outer_px)));
  const int bottom = std::min(shown.bottom, static_cast<int>(std::floor(disc.row + disc.outer_px)));
  for (int row = top; row <= bottom; ++row) {
    const auto see_columns = [&](int first, int last) {
      if (first <= last) see(Run{row, first, last});
    };
    const double outer = half_chord_px(disc.outer_px, row - disc.row);
    const double inner = half_chord_px(disc.inner_px, row - disc.row);
    const int left = std::max(shown.left, static_cast<int>(std::ceil(disc.column - outer)));
    const int right = std::min(shown.right, static_cast<int>(std::floor(disc.column + outer)));
    if (inner < 0.0) {
      see_columns(left, right);
    } else {
      see_columns(left, std::min(right, static_cast<int>(std::floor(disc.column - inner))));
      see_columns(std::max(left, static_cast<int>(std::ceil(disc.column + inner))), right);
    }
  }
}

}  // namespace tripoint
