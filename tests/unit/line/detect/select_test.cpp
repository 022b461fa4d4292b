#include "line/detect/select.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bench/painter.h"

namespace tripoint {
namespace {

/// A picture whose cells of 8 px are uniform in V.
bench::YuyvPicture picture_of_cells(int columns, int rows, const std::vector<int>& cells) {
  bench::YuyvPicture picture{.size = {columns * 8, rows * 8}, .bytes = {}};
  for (int v = 0; v < rows * 8; ++v) {
    for (int u = 0; u < columns * 8; u += 2) {
      const auto red = static_cast<std::uint8_t>(cells[static_cast<std::size_t>(v / 8 * columns + u / 8)]);
      for (const std::uint8_t byte : {std::uint8_t{16}, std::uint8_t{128}, std::uint8_t{16}, red}) {
        picture.bytes.push_back(byte);
      }
    }
  }
  return picture;
}

Selection selection_of(const bench::YuyvPicture& picture, const LedDetectorSettings& settings = {}) {
  CoarseMap map;
  map.read(picture.view());
  return select_cells(map, settings);
}

bool holds(const Selection& selection, int u_px, int v_px, int size_px) {
  return std::any_of(selection.cells.begin(), selection.cells.end(), [&](const Cell& cell) {
    return cell.u_px == u_px && cell.v_px == v_px && cell.size_px == size_px;
  });
}

/// The definition in select.h, one cell at a time.
bool stands_alone(const CellMap& map, int x, int y, const LedDetectorSettings& settings) {
  const int value = map.row(y)[x];
  if (value < settings.min_red) return false;
  int bright = 0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int other = map.row(y + dy)[x + dx];
      const bool ring = std::max(std::abs(dx), std::abs(dy)) == 2;
      if (ring && other >= value - settings.ring_step) ++bright;
      if (ring || (dx == 0 && dy == 0)) continue;
      const bool earlier = dy < 0 || (dy == 0 && dx < 0);
      if (other > value || (earlier && other == value)) return false;
    }
  }
  return bright <= settings.max_ring_cells;
}

TEST(SelectTest, VectorsAgreeWithTheDefinitionCellByCell) {
  LedDetectorSettings settings;
  settings.max_candidates = 512;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const int columns = 17 + static_cast<int>(random() % 30);
    const int rows = 9 + static_cast<int>(random() % 20);
    std::vector<int> cells(static_cast<std::size_t>(columns * rows));
    for (int& cell : cells) cell = 130 + static_cast<int>(random() % 16) + (random() % 12 == 0 ? 50 : 0);
    const auto picture = picture_of_cells(columns, rows, cells);
    CoarseMap map;
    map.read(picture.view());
    const Selection selection = select_cells(map, settings);
    std::size_t expected = 0;
    int size_px = 8;
    for (const CellMap& level : map.levels()) {
      for (int y = 0; y < level.rows(); ++y) {
        for (int x = 0; x < level.columns(); ++x) {
          if (!stands_alone(level, x, y, settings)) continue;
          ++expected;
          EXPECT_TRUE(holds(selection, x * size_px, y * size_px, size_px)) << "seed " << seed;
        }
      }
      size_px *= 2;
    }
    EXPECT_EQ(selection.cells.size(), expected) << "seed " << seed;
    EXPECT_GT(expected, 0U);
  }
}

TEST(SelectTest, NothingIsSelectedWithinAWideRedArea) {
  // Its corners may be: they stand as free as a spot does, and fall at the next gates.
  for (const Cell& cell : selection_of(picture_of_cells(40, 30, std::vector<int>(1200, 200))).cells) {
    EXPECT_TRUE(cell.u_px < 16 || cell.u_px > 288) << cell.u_px;
    EXPECT_TRUE(cell.v_px < 16 || cell.v_px > 208) << cell.v_px;
  }
}

TEST(SelectTest, CellJustBelowTheRedLimitIsNotSelected) {
  std::vector<int> cells(1200, 128);
  cells[15 * 40 + 20] = LedDetectorSettings{}.min_red - 1;
  EXPECT_TRUE(selection_of(picture_of_cells(40, 30, cells)).cells.empty());
  cells[15 * 40 + 20] = LedDetectorSettings{}.min_red;
  EXPECT_TRUE(holds(selection_of(picture_of_cells(40, 30, cells)), 160, 120, 8));
}

TEST(SelectTest, CapKeepsTheStrongestAndIsReported) {
  std::vector<int> cells(1200, 128);
  for (int y = 2; y < 30; y += 4) {
    for (int x = 2; x < 40; x += 4) cells[static_cast<std::size_t>(y * 40 + x)] = 180;
  }
  cells[18 * 40 + 22] = 240;
  LedDetectorSettings settings;
  settings.max_candidates = 5;
  const Selection selection = selection_of(picture_of_cells(40, 30, cells), settings);
  EXPECT_TRUE(selection.cut);
  EXPECT_EQ(selection.cells.size(), 5U);
  EXPECT_TRUE(holds(selection, 22 * 8, 18 * 8, 8));
  EXPECT_FALSE(selection_of(picture_of_cells(40, 30, cells)).cut);
}

}  // namespace
}  // namespace tripoint
