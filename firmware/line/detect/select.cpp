#include "line/detect/select.h"

#include <algorithm>
#include <bit>

#include "line/detect/vectors.h"

namespace tripoint {
namespace {

constexpr int kCellsAtOnce = 16;

/// 255 where no neighbour is larger; an equal one must come later in reading order.
Bytes16 local_maxima(const CellMap& map, int x, int y) {
  const std::uint8_t* above = map.row(y - 1) + x;
  const std::uint8_t* here = map.row(y) + x;
  const std::uint8_t* below = map.row(y + 1) + x;
  const auto center = loaded<Bytes16>(here);
  const Bytes16 before = larger(larger(loaded<Bytes16>(above - 1), loaded<Bytes16>(above)),
                                larger(loaded<Bytes16>(above + 1), loaded<Bytes16>(here - 1)));
  const Bytes16 after = larger(larger(loaded<Bytes16>(below - 1), loaded<Bytes16>(below)),
                               larger(loaded<Bytes16>(below + 1), loaded<Bytes16>(here + 1)));
  return reinterpret_cast<Bytes16>(center > before) & reinterpret_cast<Bytes16>(center >= after);
}

template <typename See>
void for_each_ring_cell(const CellMap& map, int x, int y, See see) {
  for (int d = -2; d <= 2; ++d) {
    see(map.row(y - 2) + x + d);
    see(map.row(y + 2) + x + d);
  }
  for (int d = -1; d <= 1; ++d) {
    see(map.row(y + d) + x - 2);
    see(map.row(y + d) + x + 2);
  }
}

/// 255 where the ring is dark enough.
Bytes16 standing_alone(const CellMap& map, int x, int y, const LedDetectorSettings& settings) {
  const Bytes16 bright = minus(loaded<Bytes16>(map.row(y) + x), all_of(settings.ring_step));
  Bytes16 count{};
  for_each_ring_cell(map, x, y, [&](const std::uint8_t* cells) {
    count -= reinterpret_cast<Bytes16>(loaded<Bytes16>(cells) >= bright);
  });
  return reinterpret_cast<Bytes16>(count <= all_of(settings.max_ring_cells));
}

Cell cell_at(const CellMap& map, int x, int y, int size_px) {
  int sum = 0;
  for_each_ring_cell(map, x, y, [&](const std::uint8_t* cell) { sum += *cell; });
  return {static_cast<std::int16_t>(x * size_px), static_cast<std::int16_t>(y * size_px),
          static_cast<std::int16_t>(size_px), static_cast<std::int16_t>(map.row(y)[x] - sum / 16)};
}

Bytes16 selected(const CellMap& map, int x, int y, const LedDetectorSettings& settings) {
  const auto red = reinterpret_cast<Bytes16>(loaded<Bytes16>(map.row(y) + x) >= all_of(settings.min_red));
  if (!any(red)) return red;
  const Bytes16 peaks = red & local_maxima(map, x, y);
  return any(peaks) ? peaks & standing_alone(map, x, y, settings) : peaks;
}

void select_level(const CellMap& map, int size_px, const LedDetectorSettings& settings, Selection& selection) {
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); x += kCellsAtOnce) {
      const Bytes16 mask = selected(map, x, y, settings);
      if (!any(mask)) continue;
      for (int k = 0; k < kCellsAtOnce; ++k) {
        if (mask[k] != 0) selection.cut |= !selection.cells.try_push_back(cell_at(map, x + k, y, size_px));
      }
    }
  }
}

void keep_the_best(Selection& selection, std::size_t limit) {
  if (selection.cells.size() <= limit) return;
  selection.cut = true;
  std::nth_element(selection.cells.begin(), selection.cells.begin() + limit, selection.cells.end(),
                   [](const Cell& a, const Cell& b) { return a.contrast > b.contrast; });
  selection.cells.truncate(limit);
}

}  // namespace

Selection select_cells(const CoarseMap& map, const LedDetectorSettings& settings) {
  Selection selection;
  int size_px = CoarseMap::kCellPx;
  for (const CellMap& level : map.levels()) {
    select_level(level, size_px, settings, selection);
    size_px *= 2;
  }
  keep_the_best(selection, static_cast<std::size_t>(settings.max_candidates));
  return selection;
}

}  // namespace tripoint
