#include "line/detect/spot_window.h"

#include <algorithm>

#include "values/assert.h"

namespace tripoint {

void SpotWindow::load(const Picture& picture, int center_u, int center_v, int half) {
  TRIPOINT_ASSERT(half > 0 && half <= kMaxHalf);
  left_px_ = (center_u - half) & ~1;
  top_px_ = center_v - half;
  columns_ = 2 * half + 2;
  rows_ = 2 * half + 1;
  for (int row = 0; row < rows_; ++row) load_row(picture, row);
}

void SpotWindow::load_row(const Picture& picture, int row) {
  const int v_px = top_px_ + row;
  if (v_px < 0 || v_px >= picture.size.height_px) {
    std::fill_n(strength_.begin() + static_cast<std::ptrdiff_t>(index(0, row)), columns_, kOutside);
  } else if (picture.interleaved_yuyv) {
    load_pairs<2, 4>(picture, row, v_px);
  } else {
    load_pairs<1, 1>(picture, row, v_px);
  }
}

/// A chroma sample sits between its two pixels: V' is three parts of the own and one of the neighbour's.
template <int kLumaStep, int kRedStep>
void SpotWindow::load_pairs(const Picture& picture, int row, int v_px) {
  const int chroma_row = picture.chroma_rows_halved ? v_px / 2 : v_px;
  const std::uint8_t* luma = picture.luma.data + static_cast<std::size_t>(v_px) * picture.luma.stride_bytes;
  const std::uint8_t* red = picture.v.data + static_cast<std::size_t>(chroma_row) * picture.v.stride_bytes;
  const int width = picture.size.width_px;
  const int last_pair = (width - 1) / 2;
  std::size_t i = index(0, row);
  for (int u_px = left_px_; u_px < left_px_ + columns_; u_px += 2, i += 2) {
    if (u_px < 0 || u_px >= width) {
      strength_[i] = strength_[i + 1] = kOutside;
      continue;
    }
    const int pair = u_px / 2;
    const int own = red[pair * kRedStep];
    const int before = red[std::max(pair - 1, 0) * kRedStep];
    const int after = red[std::min(pair + 1, last_pair) * kRedStep];
    const int first = luma[u_px * kLumaStep];
    const int second = luma[std::min(u_px + 1, width - 1) * kLumaStep];
    luma_[i] = static_cast<std::uint8_t>(first);
    luma_[i + 1] = static_cast<std::uint8_t>(second);
    red_[i] = red_[i + 1] = static_cast<std::uint8_t>(own);
    strength_[i] = static_cast<std::int16_t>(3 * (first + own) + before);
    strength_[i + 1] = u_px + 1 < width ? static_cast<std::int16_t>(3 * (second + own) + after) : kOutside;
  }
}

}  // namespace tripoint
