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

/// Where the rows of a row of cells begin.
template <std::size_t kRows>
using RowStarts = std::array<const std::uint8_t*, kRows>;

template <std::size_t kRows>
RowStarts<kRows> row_starts(const Plane& plane, int first_row) {
  RowStarts<kRows> starts{};
  for (std::size_t k = 0; k < kRows; ++k) {
    starts[k] = plane.data + (static_cast<std::size_t>(first_row) + k) * plane.stride_bytes;
  }
  return starts;
}

/// With every row at a multiple of 16 bytes, as in a driver's buffers, a load and a maximum are one instruction.
enum class Align : bool { kSixteen, kAny };

template <std::size_t kRows, Align kAlign = Align::kAny>
Bytes16 largest_of_rows(const RowStarts<kRows>& starts, std::size_t offset) {
  const auto row = [&](std::size_t k) {
    const std::uint8_t* from = starts[k] + offset;
    if constexpr (kAlign == Align::kSixteen) return loaded<Bytes16>(__builtin_assume_aligned(from, 16));
    return loaded<Bytes16>(from);
  };
  Bytes16 largest = row(0);
  for (std::size_t k = 1; k < kRows; ++k) largest = larger(largest, row(k));
  return largest;
}

/// Eight rows are eight streams, too many for the hardware to foresee: the next row of cells is fetched meanwhile.
void fetch(const RowStarts<8>& starts, std::size_t offset) {
  for (const std::uint8_t* start : starts) __builtin_prefetch(start + offset);
}

/// Four cells of YUYV: 16 bytes (Y U Y V four times) by 8 rows each.
template <Align kAlign>
std::uint32_t four_cells_of_yuyv(const RowStarts<8>& starts, std::size_t offset) {
  const auto v_of = [&](std::size_t cell) {
    return reinterpret_cast<Words4>(largest_of_rows<8, kAlign>(starts, offset + 16 * cell));
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
template <std::size_t kRows>
std::uint32_t four_cells_of_plane(const RowStarts<kRows>& starts, std::size_t offset) {
  Bytes16 m = largest_of_rows(starts, offset);
  m = larger(m, reinterpret_cast<Bytes16>(reinterpret_cast<Words4>(m) >> 16U));
  m = larger(m, reinterpret_cast<Bytes16>(reinterpret_cast<Words4>(m) >> 8U));
  const Bytes16 packed = __builtin_shufflevector(m, m, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12);
  return reinterpret_cast<Words4>(packed)[0];
}

/// One row of cells; `four` gives four whole cells from their first column on.
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

template <Align kAlign>
void read_row_of_yuyv(CellMap& map, const Picture& picture, int row) {
  const auto starts = row_starts<8>(picture.luma, row * CoarseMap::kCellPx);
  const bool last = row + 2 > picture.size.height_px / CoarseMap::kCellPx;
  const std::size_t ahead = last ? 0 : CoarseMap::kCellPx * picture.luma.stride_bytes;
  fill_row(map, picture, row, [&](int column) {
    const std::size_t offset = 16 * static_cast<std::size_t>(column);
    fetch(starts, offset + ahead);
    return four_cells_of_yuyv<kAlign>(starts, offset);
  });
}

template <std::size_t kRows>
void read_row_of_plane(CellMap& map, const Picture& picture, int row) {
  const auto starts = row_starts<kRows>(picture.v, row * static_cast<int>(kRows));
  fill_row(map, picture, row,
           [&](int column) { return four_cells_of_plane(starts, 4 * static_cast<std::size_t>(column)); });
}

bool rows_aligned(const Plane& plane) {
  return ((reinterpret_cast<std::uintptr_t>(plane.data) | plane.stride_bytes) & 15U) == 0;
}

void read_row(CellMap& map, const Picture& picture, int row) {
  if (!picture.interleaved_yuyv) {
    picture.chroma_rows_halved ? read_row_of_plane<4>(map, picture, row) : read_row_of_plane<8>(map, picture, row);
  } else if (rows_aligned(picture.luma)) {
    read_row_of_yuyv<Align::kSixteen>(map, picture, row);
  } else {
    read_row_of_yuyv<Align::kAny>(map, picture, row);
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

/// Rows of cells that lie in the band as a whole.
void CoarseMap::read_rows(const Picture& picture, const RowBand& band) {
  const bool to_the_end = band.bottom_px >= picture.size.height_px;
  const int last = to_the_end ? levels_[0].rows() : band.bottom_px / kCellPx;
  for (int row = (band.top_px + kCellPx - 1) / kCellPx; row < last; ++row) read_row(levels_[0], picture, row);
}

void CoarseMap::read(const Picture& picture) {
  TRIPOINT_ASSERT(picture.v.data != nullptr);
  used_ = picture.size.width_px >= 640 ? 3 : 2;
  levels_[0].resize((picture.size.width_px + 7) / kCellPx, (picture.size.height_px + 7) / kCellPx);
  for (const RowBand& band : picture.bands) read_rows(picture, band);
  if (picture.bands.empty()) read_rows(picture, {0, picture.size.height_px});
  for (std::size_t k = 1; k < used_; ++k) {
    levels_[k].resize((levels_[k - 1].columns() + 1) / 2, (levels_[k - 1].rows() + 1) / 2);
    halve(levels_[k - 1], levels_[k]);
  }
}

}  // namespace tripoint
