#include "line/detect/flood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tripoint {
namespace {

struct Sums {
  long n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(int column, int row) {
    n += 1;
    x += column;
    y += row;
    xx += column * column;
    yy += row * row;
    xy += column * row;
  }
};

Area area_from(const Sums& sums) {
  constexpr double kOfPixel = 1.0 / 12.0;
  const auto n = static_cast<double>(sums.n);
  const double x = static_cast<double>(sums.x) / n;
  const double y = static_cast<double>(sums.y) / n;
  const double xx = static_cast<double>(sums.xx) / n - x * x + kOfPixel;
  const double yy = static_cast<double>(sums.yy) / n - y * y + kOfPixel;
  const double xy = static_cast<double>(sums.xy) / n - x * y;
  const double difference = std::hypot(xx - yy, 2.0 * xy);
  return {.pixels = static_cast<int>(sums.n),
          .column = x,
          .row = y,
          .long_axis_px = std::sqrt(0.5 * (xx + yy + difference)),
          .short_axis_px = std::sqrt(std::max(0.5 * (xx + yy - difference), 0.02))};
}

}  // namespace

double Area::radius_px() const { return std::sqrt(pixels / std::numbers::pi); }

Area Flood::spread(const SpotWindow& window, const SpotWindow::Part& part, std::size_t seed, int level) {
  constexpr std::size_t kStride = SpotWindow::kStride;
  for (const std::uint16_t i : area()) marked_[i] = 0;
  Sums sums;
  bool cut = false;
  marked_[seed] = 1;
  reached_[0] = static_cast<std::uint16_t>(seed);
  pixels_ = 1;
  for (std::size_t next_out = 0; next_out < pixels_; ++next_out) {
    const std::size_t here = reached_[next_out];
    const int row = static_cast<int>(here / kStride);
    const int column = static_cast<int>(here % kStride);
    if (column == part.left || row == part.top || column == part.right || row == part.bottom) {
      return {.leaves_part = true};
    }
    sums.add(column, row);
    for (const std::size_t next : {here - 1, here + 1, here - kStride, here + kStride}) {
      if (window.strength(next) < level) {
        cut |= window.outside(next);
        continue;
      }
      if (marked_[next] != 0) continue;
      marked_[next] = 1;
      reached_[pixels_++] = static_cast<std::uint16_t>(next);
    }
  }
  Area area = area_from(sums);
  area.cut_by_border = cut;
  return area;
}

}  // namespace tripoint
