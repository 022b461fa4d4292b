#include "line/detect/surround.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "line/detect/disc.h"
#include "values/linear.h"

namespace tripoint {
namespace {

constexpr int kFewestPixels = 8;
constexpr double kFlankOfNoise = 2.0;  // the flank begins where the pattern of the ground ends

/// Counts values so that percentiles need no sorting; a second count by groups of bins makes them quick to find.
template <std::size_t kBins>
class Histogram {
 public:
  void add(int bin) {
    ++counts_[static_cast<std::size_t>(bin)];
    ++groups_[static_cast<std::size_t>(bin) / kGroup];
    ++n_;
  }

  /// The bin below which `share` of all lie.
  [[nodiscard]] int percentile(double share) const {
    int left = static_cast<int>(n_ * share);
    std::size_t group = 0;
    while (group + 1 < groups_.size() && left >= groups_[group]) left -= groups_[group++];
    std::size_t bin = group * kGroup;
    while (bin + 1 < kBins && left >= counts_[bin]) left -= counts_[bin++];
    return static_cast<int>(bin);
  }
  /// Standard deviation in bins, from the middle 60 %: 1.683 of a Gaussian's.
  [[nodiscard]] double noise() const { return (percentile(0.8) - percentile(0.2)) / 1.683; }
  [[nodiscard]] double share_above(int bin) const {
    return static_cast<double>(std::accumulate(counts_.begin() + bin + 1, counts_.end(), 0)) / n_;
  }
  [[nodiscard]] int size() const { return n_; }

 private:
  static constexpr std::size_t kGroup = 16;
  std::array<std::uint16_t, kBins> counts_{};
  std::array<std::uint16_t, kBins / kGroup + 1> groups_{};
  int n_ = 0;
};

constexpr int kStrengthBin = 4;  // S: fine enough against a contrast of 45 and more
using StrengthHistogram = Histogram<7 * 255 / kStrengthBin + 1>;

/// Calls `see` with the index of each pixel of the picture whose distance is within the disc.
template <typename See>
void for_each_pixel(const SpotWindow& window, const Disc& disc, See see) {
  for_each_run(window.in_picture(), disc, [&](const Run& run) {
    const std::size_t start = SpotWindow::index(0, run.row);
    for (int column = run.first; column <= run.last; ++column) see(start + static_cast<std::size_t>(column));
  });
}

/// Sums of a quantity over pixels.
struct Moments {
  int sum = 0;
  int by_column = 0;
  int by_row = 0;

  void add(int value, int column, int row) {
    sum += value;
    by_column += value * column;
    by_row += value * row;
  }
  [[nodiscard]] Vec2 middle() const { return Vec2(by_column, by_row) / sum; }
};

}  // namespace

double surround_reach_px(const Area& area) { return 2.0 * area.radius_px() + 4.5; }

Surround surround_of(const SpotWindow& window, const Area& area, int peak) {
  StrengthHistogram strengths;
  Histogram<256> lumas;
  Histogram<256> reds;
  const double reach_px = surround_reach_px(area);
  for_each_pixel(window, {area.column, area.row, reach_px - 3.0, reach_px}, [&](std::size_t i) {
    strengths.add(window.strength(i) / kStrengthBin);
    lumas.add(window.luma(i));
    reds.add(window.red(i));
  });
  if (strengths.size() < kFewestPixels) return {};
  const int strength = kStrengthBin * strengths.percentile(0.4);
  const int bright = strength + static_cast<int>(0.4 * (peak - strength));
  return {.pixels = strengths.size(),
          .strength = strength,
          .luma = lumas.percentile(0.4),
          .red = reds.percentile(0.5),
          .crowding = strengths.share_above(bright / kStrengthBin),
          .luma_noise = lumas.noise(),
          .strength_noise = kStrengthBin * strengths.noise()};
}

int background_of(const SpotWindow& window, const SpotWindow::Part& part) {
  StrengthHistogram strengths;
  const auto see = [&](int column, int row) {
    const std::size_t i = SpotWindow::index(column, row);
    if (!window.outside(i)) strengths.add(window.strength(i) / kStrengthBin);
  };
  for (int column = part.left; column <= part.right; ++column) {
    see(column, part.top);
    see(column, part.bottom);
  }
  for (int row = part.top + 1; row < part.bottom; ++row) {
    see(part.left, row);
    see(part.right, row);
  }
  return strengths.size() < kFewestPixels ? SpotWindow::kOutside : kStrengthBin * strengths.percentile(0.4);
}

double redness_of_flank(const SpotWindow& window, const Area& area, const Surround& around, int peak) {
  const double contrast = peak - around.strength;
  const double above_ground = std::clamp(kFlankOfNoise * around.strength_noise, 0.12 * contrast, 0.4 * contrast);
  const auto low = static_cast<int>(std::ceil(around.strength + above_ground));
  const auto high = static_cast<int>(std::floor(around.strength + 0.85 * contrast));
  int pixels = 0;
  int red = 0;
  int luma = 0;
  for_each_pixel(window, {area.column, area.row, -1.0, 2.2 * area.radius_px() + 1.5}, [&](std::size_t i) {
    if (window.strength(i) < low || window.strength(i) > high) return;
    ++pixels;
    red += window.red(i) - around.red;
    luma += window.luma(i) - around.luma;
  });
  if (pixels == 0) return 0.0;
  // Half a step a pixel keeps the quotient finite where Y does not rise at all.
  return red / (std::max(luma, 0) + 0.5 * pixels);
}

AreaLight light_of_area(const SpotWindow& window, const Flood& flood, const Surround& around) {
  int strength = 0;
  Moments luma;
  Moments red;
  for (const std::uint16_t i : flood.area()) {
    const int column = i % SpotWindow::kStride;
    const int row = i / SpotWindow::kStride;
    strength += window.strength(i) - around.strength;
    luma.add(window.luma(i) - around.luma, column, row);
    red.add(window.red(i) - around.red, column, row);
  }
  if (strength <= 0) return {};
  AreaLight light{.emission = static_cast<double>(luma.sum) / strength};
  light.parting_px =
      luma.sum > 0 && red.sum > 0 ? (luma.middle() - red.middle()).norm() : std::numeric_limits<double>::infinity();
  return light;
}

}  // namespace tripoint
