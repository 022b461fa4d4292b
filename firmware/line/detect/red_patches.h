// Connected red areas of a picture, seen at half its size: that of its chroma.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "line/detect/sphere_settings.h"
#include "ports/frame.h"

namespace tripoint {

/// One connected area; cells are 2x2 px.
struct RedPatch {
  std::int32_t label = 0;
  int cells = 0;
  int left = 0;  ///< in cells; right and bottom belong to it
  int top = 0;
  int right = 0;
  int bottom = 0;
};

class RedPatches {
 public:
  static constexpr int kCell_px = 2;

  /// Reads the whole picture once; allocates only when its size changes.
  void read(const Picture& picture, const SphereSettings& settings);

  /// Those of at least so many cells, the largest first.
  [[nodiscard]] std::vector<RedPatch> at_least(int cells) const;

  /// The patch of a cell; 0 where it is not red or outside.
  [[nodiscard]] std::int32_t label(int column, int row) const {
    const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
    return inside ? labels_[index(column, row)] : 0;
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  std::int32_t root(std::int32_t label);
  void join(int column, int row);
  void measure();

  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::int32_t> labels_;
  std::vector<std::int32_t> parents_;  ///< of each label; 0 is none
  std::vector<RedPatch> patches_;      ///< of each label that is its own root
};

}  // namespace tripoint
