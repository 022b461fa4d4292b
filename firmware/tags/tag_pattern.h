// What is known of the inside of a tag before it is seen: where its cells are and where light ones meet dark ones.
#pragma once

#include <vector>

#include "values/linear.h"
#include "values/tag_cells.h"

namespace tripoint {

/// Between two cells, at the middle of the side that they share.
struct CellSide {
  Vec2 at = Vec2::Zero();    ///< as in TagPlane
  bool between_x = false;    ///< the cells lie side by side, otherwise one below the other
  bool light_after = false;  ///< the right one, or the lower one, is the light one
};

struct CellMiddle {
  Vec2 at = Vec2::Zero();
  bool light = false;
};

struct TagPattern {
  int cells_across = 8;          ///< of the square with the four corners
  bool light_inside = false;     ///< just within its edges; just outside it is the other way round
  std::vector<CellMiddle> bits;  ///< of the cells that are read
  std::vector<CellSide> sides;   ///< between a light and a dark cell; not those on the square's own edges

  /// As in TagPlane.
  [[nodiscard]] double cell() const { return 2.0 / cells_across; }
};

TagPattern pattern_of(const TagCells& cells);

}  // namespace tripoint
