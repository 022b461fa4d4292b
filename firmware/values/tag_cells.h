// What is printed of an AprilTag: its light and dark cells.
#pragma once

#include <cstddef>
#include <vector>

namespace tripoint {

/// A square of cells, those of the quiet zone among them; the square with the four corners is in the middle.
struct TagCells {
  int across = 8;           ///< of the square with the four corners
  int total = 10;           ///< of all that is printed
  std::vector<bool> light;  ///< total x total, row by row from the upper left

  [[nodiscard]] bool is_light(int column, int row) const {
    return light[static_cast<std::size_t>(row) * static_cast<std::size_t>(total) + static_cast<std::size_t>(column)];
  }
};

}  // namespace tripoint
