#include "tags/tag_pattern.h"

#include <algorithm>

namespace tripoint {
namespace {

/// A cell by its place in the square with the corners: 0 is the first within, -1 the last before it.
struct Cell {
  int column;
  int row;
};

class Print {
 public:
  explicit Print(const TagCells& cells) : cells_(cells), before_((cells.total - cells.across) / 2) {}

  [[nodiscard]] bool is_light(Cell cell) const { return cells_.is_light(cell.column + before_, cell.row + before_); }
  [[nodiscard]] bool is_read(Cell cell) const { return cells_.is_read(cell.column + before_, cell.row + before_); }
  /// Read, or one of the two rings of cells on both sides of the square's edges.
  [[nodiscard]] bool is_known(Cell cell) const {
    const int depth = std::min({cell.column, cell.row, cells_.across - 1 - cell.column, cells_.across - 1 - cell.row});
    return is_printed(cell) && (depth == 0 || depth == -1 || is_read(cell));
  }
  [[nodiscard]] bool is_within(Cell cell) const {
    return std::min(cell.column, cell.row) >= 0 && std::max(cell.column, cell.row) < cells_.across;
  }
  [[nodiscard]] int first() const { return -before_; }
  [[nodiscard]] int end() const { return cells_.total - before_; }
  [[nodiscard]] double size() const { return 2.0 / cells_.across; }
  [[nodiscard]] Vec2 middle_of(Cell cell) const {
    return size() * Vec2(cell.column + 0.5, cell.row + 0.5) - Vec2::Ones();
  }

 private:
  [[nodiscard]] bool is_printed(Cell cell) const {
    return std::min(cell.column, cell.row) >= first() && std::max(cell.column, cell.row) < end();
  }

  const TagCells& cells_;
  int before_;
};

void add_side(const Print& print, Cell cell, Cell after, TagPattern& pattern) {
  if (!print.is_known(cell) || !print.is_known(after) || print.is_within(cell) != print.is_within(after)) return;
  if (print.is_light(cell) == print.is_light(after)) return;
  pattern.sides.push_back({.at = 0.5 * (print.middle_of(cell) + print.middle_of(after)),
                           .between_x = after.column > cell.column,
                           .light_after = print.is_light(after)});
}

}  // namespace

TagPattern pattern_of(const TagCells& cells) {
  const Print print(cells);
  TagPattern pattern{
      .cells_across = cells.across, .light_inside = print.is_light({.column = 0, .row = 0}), .bits = {}, .sides = {}};
  for (int row = print.first(); row < print.end(); ++row) {
    for (int column = print.first(); column < print.end(); ++column) {
      const Cell cell{column, row};
      if (print.is_read(cell)) pattern.bits.push_back({print.middle_of(cell), print.is_light(cell)});
      add_side(print, cell, {column + 1, row}, pattern);
      add_side(print, cell, {column, row + 1}, pattern);
    }
  }
  return pattern;
}

}  // namespace tripoint
