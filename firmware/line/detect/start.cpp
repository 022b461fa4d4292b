#include "line/detect/start.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "line/detect/shared_chroma.h"
#include "line/detect/vectors.h"

namespace tripoint {
namespace {

/// Columns and rows of cells, inclusive.
struct CellBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

CellBox cells_within(const CellMap& cells, const RawPixel& at, int reach_px) {
  const auto cell_of = [](double px) { return static_cast<int>(px) / CoarseMap::kCellPx; };
  return {cell_of(std::max(0.0, at.u_px - reach_px)), cell_of(std::max(0.0, at.v_px - reach_px)),
          std::min(cells.columns() - 1, cell_of(at.u_px + reach_px)),
          std::min(cells.rows() - 1, cell_of(at.v_px + reach_px))};
}

/// The cell of the finest level that holds the larger cell's maximum.
Cell finest(const CoarseMap& map, Cell cell) {
  while (cell.size_px > CoarseMap::kCellPx) {
    const auto half = static_cast<std::int16_t>(cell.size_px / 2);
    const auto level = static_cast<std::size_t>(half == CoarseMap::kCellPx ? 0 : 1);
    const int x = cell.u_px / half;
    const int y = cell.v_px / half;
    const std::uint8_t* upper = map.levels()[level].row(y) + x;
    const std::uint8_t* lower = map.levels()[level].row(y + 1) + x;
    const int largest = std::max(std::max(upper[0], upper[1]), std::max(lower[0], lower[1]));
    const bool below = upper[0] != largest && upper[1] != largest;
    const bool right = below ? lower[0] != largest : upper[0] != largest;
    cell.u_px = static_cast<std::int16_t>(cell.u_px + (right ? half : 0));
    cell.v_px = static_cast<std::int16_t>(cell.v_px + (below ? half : 0));
    cell.size_px = half;
  }
  return cell;
}

/// Calls `see(u, v, V)` once for each chroma sample of a cell of the finest level that lies in the picture.
template <typename See>
void for_each_red(const Picture& picture, int column, int row, See see) {
  const int step = picture.chroma_rows_halved ? 2 : 1;
  const int right = std::min((column + 1) * CoarseMap::kCellPx, picture.size.width_px);
  const int bottom = std::min((row + 1) * CoarseMap::kCellPx, picture.size.height_px);
  for (int v = row * CoarseMap::kCellPx; v < bottom; v += step) {
    const std::uint8_t* reds = picture.v.row(v / step);
    for (int u = column * CoarseMap::kCellPx; u < right; u += 2) {
      see(u, v, reds[static_cast<std::size_t>(u / 2) * picture.v.step_bytes]);
    }
  }
}

/// Of the samples whose V is `largest` the first with the most luma; the cell's corner if there is none.
PixelPlace brightest_of_reddest(const Picture& picture, const Cell& fine, int largest) {
  PixelPlace reddest{fine.u_px, fine.v_px};
  int brightest = -1;
  for_each_red(picture, fine.u_px / CoarseMap::kCellPx, fine.v_px / CoarseMap::kCellPx, [&](int u, int v, int red) {
    if (red != largest || picture.luma.at(u, v) <= brightest) return;
    brightest = picture.luma.at(u, v);
    reddest = {u, v};
  });
  return reddest;
}

/// The same of a whole cell, a row of its four samples at a time. A sample is one word: Y0 U Y1 V.
PixelPlace brightest_of_reddest_yuyv(const Picture& picture, const Cell& fine, int largest) {
  constexpr Words4 kRankInRow{4, 3, 2, 1};  // the first of equals has the highest
  Words4 best{};
  const std::uint8_t* yuyv = picture.luma.row(fine.v_px) + 2 * static_cast<std::size_t>(fine.u_px);
  for (std::uint32_t rows_left = CoarseMap::kCellPx; rows_left > 0; --rows_left) {
    const auto samples = loaded<Words4>(yuyv);
    const Words4 rank = (samples & 0xFFU) << 8U | (kRankInRow + 8 * (rows_left - 1));
    const auto is_reddest = reinterpret_cast<Words4>(samples >> 24U == static_cast<std::uint32_t>(largest));
    best = larger(best, rank & is_reddest);
    yuyv += picture.luma.stride_bytes;
  }
  const std::uint32_t rank = std::max(std::max(best[0], best[1]), std::max(best[2], best[3])) & 0xFFU;
  if (rank == 0) return {fine.u_px, fine.v_px};
  const auto column = static_cast<int>(4 - rank % 8);
  const auto row = static_cast<int>(CoarseMap::kCellPx - 1 - rank / 8);
  return {fine.u_px + 2 * column, fine.v_px + row};
}

bool whole(const Picture& picture, const Cell& fine) {
  return fine.u_px + CoarseMap::kCellPx <= picture.size.width_px &&
         fine.v_px + CoarseMap::kCellPx <= picture.size.height_px;
}

}  // namespace

PixelPlace reddest_of_cell(const Picture& picture, const CoarseMap& map, const Cell& cell) {
  const Cell fine = finest(map, cell);
  const int largest = map.levels().front().row(fine.v_px / CoarseMap::kCellPx)[fine.u_px / CoarseMap::kCellPx];
  return picture.interleaved_yuyv && whole(picture, fine) ? brightest_of_reddest_yuyv(picture, fine, largest)
                                                          : brightest_of_reddest(picture, fine, largest);
}

std::optional<PixelPlace> reddest_beside(const Picture& picture, const CoarseMap& map, const Candidate& spot,
                                         int min_red) {
  constexpr int kGrey = 128;            // V
  constexpr int kClearlyRed = 20;       // V above `min_red`
  constexpr double kNearlyAsRed = 0.6;  // of the accepted spot's own step
  const int reach = picture.size.width_px <= 320 ? 14 : 26;
  const double own = 2.0 * static_cast<double>(spot.radius_px) + 2.0;
  const double clearly_red = kGrey + red_left(picture) * (min_red + kClearlyRed - kGrey);
  const double needed =
      std::max(clearly_red, static_cast<double>(spot.surround_red) + kNearlyAsRed * static_cast<double>(spot.red_step));
  int largest = static_cast<int>(std::ceil(needed)) - 1;
  std::optional<PixelPlace> reddest;
  const auto see = [&](int u, int v, int red) {
    if (red <= largest) return;
    const double du = u - spot.at.u_px;
    const double dv = v - spot.at.v_px;
    if (std::max(std::abs(du), std::abs(dv)) > reach || du * du + dv * dv < own * own) return;
    largest = red;
    reddest = PixelPlace{u, v};
  };
  const CellMap& cells = map.levels().front();
  const CellBox box = cells_within(cells, spot.at, reach);
  for (int row = box.top; row <= box.bottom; ++row) {
    for (int column = box.left; column <= box.right; ++column) {
      if (cells.row(row)[column] > largest) for_each_red(picture, column, row, see);
    }
  }
  return reddest;
}

}  // namespace tripoint
