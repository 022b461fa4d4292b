// The coarse map: the largest V of every cell of 8x8 px, then of 16x16 and 32x32, in one read of the picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ports/frame.h"

namespace tripoint {

/// One level. Cells outside the picture may be read up to `kMargin` away and are 0.
class CellMap {
 public:
  static constexpr int kMargin = 2;

  /// Allocates only when the size changes.
  void resize(int columns, int rows);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] std::uint8_t* row(int y) { return cells_.data() + offset(y); }
  [[nodiscard]] const std::uint8_t* row(int y) const { return cells_.data() + offset(y); }

 private:
  [[nodiscard]] std::size_t offset(int y) const { return static_cast<std::size_t>(y + kMargin) * stride_ + kLead; }

  static constexpr std::size_t kLead = 16;  ///< bytes before column 0, for unaligned reads to the left
  std::vector<std::uint8_t> cells_;
  std::size_t stride_ = 0;
  int columns_ = 0;
  int rows_ = 0;
};

class CoarseMap {
 public:
  static constexpr int kCellPx = 8;
  static constexpr std::size_t kLevels = 3;

  /// Reads the whole picture, or its bands: the other cells keep what they last showed. The 32 px level exists from
  /// 640 px width up.
  void read(const Picture& picture);

  /// Cells of 8, 16 and 32 px.
  [[nodiscard]] std::span<const CellMap> levels() const { return {levels_.data(), used_}; }

 private:
  void read_rows(const Picture& picture, const RowBand& band);

  std::array<CellMap, kLevels> levels_;
  std::size_t used_ = 0;
};

}  // namespace tripoint
