// What is printed of an AprilTag: its light and dark cells.
#pragma once

#include <cstddef>
#include <vector>

namespace tripoint {

/// A square of cells, those of the quiet zone among them; the square with the four corners is in the middle.
struct TagCells {
  int across = 8;            ///< of the square with the four corners
  int total = 10;            ///< of all that is printed
  std::vector<bool> light;   ///< total x total, row by row from the upper left
  std::vector<bool> read{};  ///< likewise: a bit of the tag's id; others are what every tag of the family shows

  [[nodiscard]] bool is_light(int column, int row) const { return light[index(column, row)]; }
  [[nodiscard]] bool is_read(int column, int row) const { return read[index(column, row)]; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(total) + static_cast<std::size_t>(column);
  }
};

}  // namespace tripoint
