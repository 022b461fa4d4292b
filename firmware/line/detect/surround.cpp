#include "line/detect/surround.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr std::size_t kFewestPixels = 8;

/// The value below which `share` of the first `n` lie; reorders them.
template <typename Values>
int percentile(Values& values, std::size_t n, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(static_cast<double>(n) * share);
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(values.begin(), values.begin() + rank, end);
  return values[static_cast<std::size_t>(rank)];
}

struct Disc {
  double column = 0.0;
  double row = 0.0;
  double inner_px = 0.0;
  double outer_px = 0.0;
};

/// Calls `see` with the index of each pixel of the picture whose distance is within the disc.
template <typename See>
void for_each_pixel(const SpotWindow& window, const Disc& disc, See see) {
  const double inner2 = disc.inner_px * disc.inner_px;
  const double outer2 = disc.outer_px * disc.outer_px;
  const int top = std::max(0, static_cast<int>(std::ceil(disc.row - disc.outer_px)));
  const int bottom = std::min(window.rows() - 1, static_cast<int>(std::floor(disc.row + disc.outer_px)));
  const int left = std::max(0, static_cast<int>(std::ceil(disc.column - disc.outer_px)));
  const int right = std::min(window.columns() - 1, static_cast<int>(std::floor(disc.column + disc.outer_px)));
  for (int row = top; row <= bottom; ++row) {
    const double dy2 = (row - disc.row) * (row - disc.row);
    for (int column = left; column <= right; ++column) {
      const double d2 = dy2 + (column - disc.column) * (column - disc.column);
      const std::size_t i = SpotWindow::index(column, row);
      if (d2 >= inner2 && d2 <= outer2 && !window.outside(i)) see(i);
    }
  }
}

}  // namespace

double surround_reach_px(const Area& area) { return 2.0 * area.radius_px() + 4.5; }

Surround SurroundMeter::measure(const SpotWindow& window, const Area& area, int peak) {
  std::size_t n = 0;
  const double reach_px = surround_reach_px(area);
  for_each_pixel(window, {area.column, area.row, reach_px - 3.0, reach_px}, [&](std::size_t i) {
    if (n == kMaxRing) return;
    strength_[n] = static_cast<std::int16_t>(window.strength(i));
    luma_[n] = static_cast<std::uint8_t>(window.luma(i));
    red_[n] = static_cast<std::uint8_t>(window.red(i));
    ++n;
  });
  if (n < kFewestPixels) return {};
  Surround around{.pixels = static_cast<int>(n),
                  .strength = percentile(strength_, n, 0.4),
                  .luma = percentile(luma_, n, 0.4),
                  .red = percentile(red_, n, 0.5)};
  const double bright = around.strength + 0.4 * (peak - around.strength);
  const auto count = std::count_if(strength_.begin(), strength_.begin() + static_cast<std::ptrdiff_t>(n),
                                   [&](std::int16_t strength) { return strength > bright; });
  around.crowding = static_cast<double>(count) / static_cast<double>(n);
  return around;
}

int SurroundMeter::background(const SpotWindow& window) {
  std::size_t n = 0;
  const auto see = [&](int column, int row) {
    const std::size_t i = SpotWindow::index(column, row);
    if (!window.outside(i)) strength_[n++] = static_cast<std::int16_t>(window.strength(i));
  };
  for (int column = 0; column < window.columns(); ++column) {
    see(column, 0);
    see(column, window.rows() - 1);
  }
  for (int row = 1; row + 1 < window.rows(); ++row) {
    see(0, row);
    see(window.columns() - 1, row);
  }
  return n < kFewestPixels ? SpotWindow::kOutside : percentile(strength_, n, 0.4);
}

double redness_of_flank(const SpotWindow& window, const Area& area, const Surround& around, int peak) {
  const double contrast = peak - around.strength;
  const double low = around.strength + 0.12 * contrast;
  const double high = around.strength + 0.85 * contrast;
  int pixels = 0;
  int red = 0;
  int luma = 0;
  for_each_pixel(window, {area.column, area.row, 0.0, 2.2 * area.radius_px() + 1.5}, [&](std::size_t i) {
    if (window.strength(i) < low || window.strength(i) > high) return;
    ++pixels;
    red += window.red(i) - around.red;
    luma += window.luma(i) - around.luma;
  });
  if (pixels == 0) return 0.0;
  // Half a step a pixel keeps the quotient finite where Y does not rise at all.
  return red / (std::max(luma, 0) + 0.5 * pixels);
}

double emission_of_area(const SpotWindow& window, const Flood& flood, const Surround& around) {
  int luma = 0;
  int strength = 0;
  for (int row = 0; row < window.rows(); ++row) {
    for (int column = 0; column < window.columns(); ++column) {
      const std::size_t i = SpotWindow::index(column, row);
      if (!flood.holds(i)) continue;
      luma += window.luma(i) - around.luma;
      strength += window.strength(i) - around.strength;
    }
  }
  return strength > 0 ? static_cast<double>(luma) / strength : 0.0;
}

}  // namespace tripoint
