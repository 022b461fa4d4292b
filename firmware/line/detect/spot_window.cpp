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
  const std::size_t first = index(0, row);
  std::fill_n(strength_.begin() + static_cast<std::ptrdiff_t>(first), columns_, kOutside);
  if (v_px < 0 || v_px >= picture.size.height_px) return;
  const int chroma_row = picture.chroma_rows_halved ? v_px / 2 : v_px;
  const std::uint8_t* luma = picture.luma.data + static_cast<std::size_t>(v_px) * picture.luma.stride_bytes;
  const std::uint8_t* red = picture.v.data + static_cast<std::size_t>(chroma_row) * picture.v.stride_bytes;
  const auto luma_step = static_cast<int>(picture.luma.step_bytes);
  const auto red_step = static_cast<int>(picture.v.step_bytes);
  const int last_pair = (picture.size.width_px - 1) / 2;
  const int end_px = std::min(left_px_ + columns_, picture.size.width_px);
  for (int u_px = std::max(left_px_, 0); u_px < end_px; ++u_px) {
    // A chroma sample sits between its two pixels: three parts of the own, one of the neighbour's.
    const int pair = u_px / 2;
    const int neighbour = std::clamp(pair + ((u_px & 1) != 0 ? 1 : -1), 0, last_pair);
    const std::size_t i = first + static_cast<std::size_t>(u_px - left_px_);
    luma_[i] = luma[u_px * luma_step];
    red_[i] = red[pair * red_step];
    strength_[i] = static_cast<std::int16_t>(3 * luma_[i] + 3 * red_[i] + red[neighbour * red_step]);
  }
}

}  // namespace tripoint
