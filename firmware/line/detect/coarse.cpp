#include "line/detect/coarse.h"

#include <algorithm>

#include "line/detect/vectors.h"
#include "values/assert.h"

namespace tripoint {
namespace {

constexpr int kCellsAtOnce = 4;

std::uint8_t largest_v_of_cell(const Picture& picture, int column, int row) {
  const int halved = picture.chroma_rows_halved ? 1 : 0;
  const int first_u = column * CoarseMap::kCellPx / 2;
  const int last_u = std::min(first_u + 3, (picture.size.width_px - 1) / 2);
  const int first_v = row * CoarseMap::kCellPx >> halved;
  const int last_v = std::min(row * CoarseMap::kCellPx + 7, picture.size.height_px - 1) >> halved;
  std::uint8_t largest = 0;
  for (int v = first_v; v <= last_v; ++v) {
    for (int u = first_u; u <= last_u; ++u) largest = std::max(largest, picture.v.at(u, v));
  }
  return largest;
}

template <int kRows>
Bytes16 largest_of_rows(const std::uint8_t* first, std::size_t stride) {
  static_assert(kRows == 4 || kRows == 8);
  const Bytes16 a = larger(loaded<Bytes16>(first), loaded<Bytes16>(first + stride));
  const Bytes16 b = larger(loaded<Bytes16>(first + 2 * stride), loaded<Bytes16>(first + 3 * stride));
  if constexpr (kRows == 4) return larger(a, b);
  const Bytes16 c = larger(loaded<Bytes16>(first + 4 * stride), loaded<Bytes16>(first + 5 * stride));
  const Bytes16 d = larger(loaded<Bytes16>(first + 6 * stride), loaded<Bytes16>(first + 7 * stride));
  return larger(larger(a, b), larger(c, d));
}

/// Eight rows are eight streams, too many for the hardware to foresee: the next row of cells is fetched meanwhile.
void fetch(const std::uint8_t* first, std::size_t stride) {
  for (std::size_t row = 0; row < 8; ++row) __builtin_prefetch(first + row * stride);
}

/// Four cells of YUYV: 16 bytes (Y U Y V four times) by 8 rows each.
std::uint32_t four_cells_of_yuyv(const std::uint8_t* first, std::size_t stride) {
  const auto v_of = [&](std::size_t cell) {
    return reinterpret_cast<Words4>(largest_of_rows<8>(first + 16 * cell, stride));
  };
  const Words4 packed =
      (v_of(0) >> 24U) | ((v_of(1) >> 16U) & 0xFF00U) | ((v_of(2) >> 8U) & 0xFF'0000U) | (v_of(3) & 0xFF00'0000U);
  const Words4 swapped = __builtin_shufflevector(packed, packed, 2, 3, 0, 1);
  const auto half =
      reinterpret_cast<Words4>(larger(reinterpret_cast<Bytes16>(packed), reinterpret_cast<Bytes16>(swapped)));
  const Words4 turned = __builtin_shufflevector(half, half, 1, 0, 3, 2);
  return reinterpret_cast<Words4>(larger(reinterpret_cast<Bytes16>(half), reinterpret_cast<Bytes16>(turned)))[0];
}

/// Four cells of a V plane: 4 bytes each.
template <int kRows>
std::uint32_t four_cells_of_plane(const std::uint8_t* first, std::size_t stride) {
  Bytes16 m = largest_of_rows<kRows>(first, stride);
  m = larger(m, reinterpret_cast<Bytes16>(reinterpret_cast<Words4>(m) >> 16U));
  m = larger(m, reinterpret_cast<Bytes16>(reinterpret_cast<Words4>(m) >> 8U));
  const Bytes16 packed = __builtin_shufflevector(m, m, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12);
  return reinterpret_cast<Words4>(packed)[0];
}

/// One row of cells; `four` gives four whole cells from the first byte of their upper left corner.
template <typename Four>
void fill_row(CellMap& map, const Picture& picture, int row, Four four) {
  std::uint8_t* cells = map.row(row);
  const bool whole_row = (row + 1) * CoarseMap::kCellPx <= picture.size.height_px;
  const int whole_cells = whole_row ? picture.size.width_px / CoarseMap::kCellPx : 0;
  int column = 0;
  for (; column + kCellsAtOnce <= whole_cells; column += kCellsAtOnce) {
    const std::uint32_t values = four(column);
    std::memcpy(cells + column, &values, sizeof values);
  }
  for (; column < map.columns(); ++column) cells[column] = largest_v_of_cell(picture, column, row);
}

void read_row(CellMap& map, const Picture& picture, int row) {
  const auto y = static_cast<std::size_t>(row) * CoarseMap::kCellPx;
  const std::size_t stride = picture.v.stride_bytes;
  if (picture.interleaved_yuyv) {
    const std::uint8_t* first = picture.luma.data + y * stride;
    const std::size_t ahead = row + 2 <= picture.size.height_px / CoarseMap::kCellPx ? 8 * stride : 0;
    fill_row(map, picture, row, [&](int column) {
      fetch(first + ahead + 16 * column, stride);
      return four_cells_of_yuyv(first + 16 * column, stride);
    });
  } else if (picture.chroma_rows_halved) {
    const std::uint8_t* first = picture.v.data + y / 2 * stride;
    fill_row(map, picture, row, [&](int column) { return four_cells_of_plane<4>(first + 4 * column, stride); });
  } else {
    const std::uint8_t* first = picture.v.data + y * stride;
    fill_row(map, picture, row, [&](int column) { return four_cells_of_plane<8>(first + 4 * column, stride); });
  }
}

void halve(const CellMap& fine, CellMap& coarse) {
  for (int y = 0; y < coarse.rows(); ++y) {
    const std::uint8_t* upper = fine.row(2 * y);
    const std::uint8_t* lower = fine.row(2 * y + 1);
    std::uint8_t* cells = coarse.row(y);
    for (int x = 0; x < coarse.columns(); x += 8) {
      // Right of the last column there are zeros, and zeros are written there.
      Bytes16 m = larger(loaded<Bytes16>(upper + 2 * x), loaded<Bytes16>(lower + 2 * x));
      m = larger(m, reinterpret_cast<Bytes16>(reinterpret_cast<Shorts8>(m) >> 8U));
      const Bytes16 packed = __builtin_shufflevector(m, m, 0, 2, 4, 6, 8, 10, 12, 14, 0, 2, 4, 6, 8, 10, 12, 14);
      std::memcpy(cells + x, &packed, 8);
    }
  }
}

}  // namespace

void CellMap::resize(int columns, int rows) {
  if (columns == columns_ && rows == rows_) return;
  columns_ = columns;
  rows_ = rows;
  // A vector of 16 cells may begin at the last column and look `kMargin` further to the right.
  stride_ = kLead + static_cast<std::size_t>(columns) + 16 + kMargin;
  cells_.assign(stride_ * static_cast<std::size_t>(rows + 2 * kMargin) + kLead, 0);
}

void CoarseMap::read(const Picture& picture) {
  TRIPOINT_ASSERT(picture.v.data != nullptr);
  used_ = picture.size.width_px >= 640 ? 3 : 2;
  levels_[0].resize((picture.size.width_px + 7) / kCellPx, (picture.size.height_px + 7) / kCellPx);
  for (int row = 0; row < levels_[0].rows(); ++row) read_row(levels_[0], picture, row);
  for (std::size_t k = 1; k < used_; ++k) {
    levels_[k].resize((levels_[k - 1].columns() + 1) / 2, (levels_[k - 1].rows() + 1) / 2);
    halve(levels_[k - 1], levels_[k]);
  }
}

}  // namespace tripoint
