#include "app/board_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "line/detect/exposure_margin.h"

namespace tripoint {
namespace {

constexpr int kColumns = 20;
constexpr double kTwoLevels = 0.85;      ///< eta: 1 of two levels, 0.75 of a slope, 0.64 of noise
constexpr double kSmallestShare = 0.1;   ///< of a part, that each of both levels has
constexpr double kLeastContrast = 0.04;  ///< of clip: noise and the lens's veil are below
constexpr double kLeastRatio = 1.3;      ///< white over black of a part, however pale
constexpr double kSmallestBoard = 0.06;  ///< of the picture; real boards that fill a quarter of it have 0.07 and more
constexpr int kNeighbours = 6;           ///< of eight: lines and edges of things have fewer

using Histogram = std::array<std::size_t, 256>;

struct Part {
  double white;
  double black;
};

Histogram histogram_of(const Plane& luma, int left, int top, int side_px) {
  Histogram histogram{};
  for (int y = top; y < top + side_px; ++y) {
    for (int x = left; x < left + side_px; ++x) ++histogram.at(luma.at(x, y));
  }
  return histogram;
}

/// The luma that so many of the values do not reach.
double luma_of_rank(const Histogram& histogram, std::size_t rank) {
  std::size_t passed = 0;
  for (std::size_t luma = 0; luma < histogram.size(); ++luma) {
    passed += histogram[luma];
    if (passed > rank) return static_cast<double>(luma);
  }
  return static_cast<double>(histogram.size() - 1);
}

/// Where a histogram is best cut into two.
struct Cut {
  std::size_t below = 0;  ///< values in the darker class
  double eta = 0.0;       ///< variance between the classes over that of all
};

Cut best_cut(const Histogram& histogram, std::size_t count) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t luma = 0; luma < histogram.size(); ++luma) {
    const auto values = static_cast<double>(histogram[luma]);
    sum += values * static_cast<double>(luma);
    squares += values * static_cast<double>(luma * luma);
  }
  const auto all = static_cast<double>(count);
  const double variance = squares / all - (sum / all) * (sum / all);
  Cut best;
  std::size_t below = 0;
  double sum_below = 0.0;
  for (std::size_t luma = 0; luma + 1 < histogram.size() && variance > 0.0; ++luma) {
    below += histogram[luma];
    sum_below += static_cast<double>(histogram[luma] * luma);
    if (below == 0 || below == count) continue;
    const auto dark = static_cast<double>(below);
    const double means_apart = (sum - sum_below) / (all - dark) - sum_below / dark;
    const double eta = dark / all * (1.0 - dark / all) * means_apart * means_apart / variance;
    if (eta > best.eta) best = {.below = below, .eta = eta};
  }
  return best;
}

/// Medians of both classes: pixels on the edges between squares are among the outer ones. Nothing when it has not two
/// levels.
std::optional<Part> part_of(const Histogram& histogram, std::size_t count) {
  const Cut cut = best_cut(histogram, count);
  const double dark_share = static_cast<double>(cut.below) / static_cast<double>(count);
  if (cut.eta < kTwoLevels || dark_share < kSmallestShare || dark_share > 1.0 - kSmallestShare) return std::nullopt;
  const Part part{.white = level_from_luma(luma_of_rank(histogram, (cut.below + count) / 2)),
                  .black = level_from_luma(luma_of_rank(histogram, cut.below / 2))};
  if (part.white - part.black < kLeastContrast || part.white < kLeastRatio * part.black) return std::nullopt;
  return part;
}

/// The picture in parts, row by row.
class Parts {
 public:
  explicit Parts(const Picture& picture)
      : side_px_(picture.size.width_px / kColumns), rows_(picture.size.height_px / side_px_) {
    const std::size_t count = static_cast<std::size_t>(side_px_) * static_cast<std::size_t>(side_px_);
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        parts_.push_back(part_of(histogram_of(picture.luma, column * side_px_, row * side_px_, side_px_), count));
      }
    }
  }

  /// Those with two levels in the midst of others.
  [[nodiscard]] std::vector<Part> of_board() const {
    std::vector<Part> found;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        if (at(row, column) && neighbours(row, column) >= kNeighbours) found.push_back(*at(row, column));
      }
    }
    return found;
  }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

 private:
  [[nodiscard]] std::optional<Part> at(int row, int column) const {
    if (row < 0 || column < 0 || row >= rows_ || column >= kColumns) return std::nullopt;
    return parts_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] int neighbours(int row, int column) const {
    int count = at(row, column) ? -1 : 0;
    for (const int down : {-1, 0, 1}) {
      for (const int across : {-1, 0, 1}) count += at(row + down, column + across) ? 1 : 0;
    }
    return count;
  }

  int side_px_;
  int rows_;
  std::vector<std::optional<Part>> parts_;
};

/// The value below which so many of them are, of 1.
double quantile(const std::vector<Part>& parts, double Part::*level, double share) {
  std::vector<double> values;
  values.reserve(parts.size());
  for (const Part& part : parts) values.push_back(part.*level);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

BoardSight board_sight(const Picture& picture) {
  const Parts parts(picture);
  const std::vector<Part> board = parts.of_board();
  BoardSight sight{.levels = {}, .share = static_cast<double>(board.size()) / static_cast<double>(parts.size())};
  if (sight.share >= kSmallestBoard) {
    sight.levels = {.white = quantile(board, &Part::white, 0.5),
                    .black = quantile(board, &Part::black, 0.5),
                    .lightest = quantile(board, &Part::white, 0.95)};
  }
  return sight;
}

}  // namespace tripoint
