#include "app/board_look.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tripoint {
namespace {

constexpr int kPictures = 5;  ///< looked at

double median(const std::vector<BoardLevels>& seen, double BoardLevels::*level) {
  std::vector<double> values;
  values.reserve(seen.size());
  for (const BoardLevels& levels : seen) values.push_back(levels.*level);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<BoardLook> look_at_board(const CameraPair& cameras) {
  BoardLook look{.setting = cameras.setting(), .board = {}};
  for (const Side side : kBothSides) {
    std::vector<BoardLevels> seen;
    const Result<void> watched = cameras.watch(side, kPictures, [&](const Picture& picture) {
      const BoardSight sight = board_sight(picture);
      look.board[side].share = sight.share;
      if (sight.levels) seen.push_back(*sight.levels);
    });
    if (!watched) return tl::make_unexpected(watched.error());
    if (2 * seen.size() <= static_cast<std::size_t>(kPictures)) continue;
    look.board[side].levels = {.white = median(seen, &BoardLevels::white),
                               .black = median(seen, &BoardLevels::black),
                               .lightest = median(seen, &BoardLevels::lightest)};
  }
  return look;
}

}  // namespace tripoint
