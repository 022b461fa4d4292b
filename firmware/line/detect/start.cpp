#include "line/detect/start.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tripoint {
namespace {

struct Box {
  int left_px = 0;
  int top_px = 0;
  int right_px = 0;  ///< inclusive
  int bottom_px = 0;
};

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

/// Calls `see(u, v, V)` once for each chroma sample of the box that lies in the picture.
template <typename See>
void for_each_red(const Picture& picture, const Box& box, See see) {
  const int step = picture.chroma_rows_halved ? 2 : 1;
  const int right = std::min(box.right_px, picture.size.width_px - 1);
  const int bottom = std::min(box.bottom_px, picture.size.height_px - 1);
  for (int v = std::max(box.top_px, 0); v <= bottom; v += step) {
    const std::uint8_t* reds = picture.v.data + static_cast<std::size_t>(v / step) * picture.v.stride_bytes;
    for (int u = std::max(box.left_px, 0) & ~1; u <= right; u += 2) {
      see(u, v, reds[static_cast<std::size_t>(u / 2) * picture.v.step_bytes]);
    }
  }
}

}  // namespace

PixelPlace reddest_of_cell(const Picture& picture, const CoarseMap& map, const Cell& cell) {
  const Cell fine = finest(map, cell);
  const Box box{fine.u_px, fine.v_px, fine.u_px + fine.size_px - 1, fine.v_px + fine.size_px - 1};
  PixelPlace reddest{fine.u_px, fine.v_px};
  int largest = -1;
  for_each_red(picture, box, [&](int u, int v, int red) {
    if (red < largest) return;
    if (red == largest && picture.luma.at(u, v) <= picture.luma.at(reddest.u_px, reddest.v_px)) return;
    largest = red;
    reddest = {u, v};
  });
  return reddest;
}

std::optional<PixelPlace> reddest_beside(const Picture& picture, const Candidate& spot, int min_red) {
  constexpr int kClearlyRed = 20;       // V above `min_red`
  constexpr double kNearlyAsRed = 0.6;  // of the accepted spot's own step
  const int reach = picture.size.width_px <= 320 ? 14 : 26;
  const auto center_u = static_cast<int>(spot.at.u_px);
  const auto center_v = static_cast<int>(spot.at.v_px);
  const double own = 2.0 * static_cast<double>(spot.radius_px) + 2.0;
  const double needed = std::max<double>(min_red + kClearlyRed, static_cast<double>(spot.surround_red) +
                                                                    kNearlyAsRed * static_cast<double>(spot.red_step));
  int largest = static_cast<int>(std::ceil(needed)) - 1;
  std::optional<PixelPlace> reddest;
  for_each_red(picture, {center_u - reach, center_v - reach, center_u + reach, center_v + reach},
               [&](int u, int v, int red) {
                 if (red <= largest) return;
                 const double du = u - spot.at.u_px;
                 const double dv = v - spot.at.v_px;
                 if (du * du + dv * dv < own * own) return;
                 largest = red;
                 reddest = PixelPlace{u, v};
               });
  return reddest;
}

}  // namespace tripoint
