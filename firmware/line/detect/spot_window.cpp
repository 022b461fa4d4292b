#include "line/detect/spot_window.h"

#include <algorithm>
#include <cstring>

#include "line/detect/vectors.h"
#include "values/assert.h"

namespace tripoint {

void SpotWindow::load(const Picture& picture, int center_u, int center_v, int half) {
  TRIPOINT_ASSERT(half > 0 && half <= kMaxHalf);
  picture_size_ = picture.size;
  left_px_ = even(center_u - half);
  top_px_ = center_v - half;
  columns_ = 2 * half + 2;
  rows_ = 2 * half + 1;
  const bool in_eights =
      picture.interleaved_yuyv && left_px_ >= 2 && left_px_ + 8 * ((columns_ + 7) / 8) + 2 <= picture.size.width_px;
  for (int row = 0; row < rows_; ++row) {
    const int v_px = top_px_ + row;
    const std::size_t first = index(0, row);
    if (v_px < 0 || v_px >= picture.size.height_px) {
      std::fill_n(strength_.begin() + static_cast<std::ptrdiff_t>(first), columns_, kOutside);
    } else if (in_eights) {
      const std::uint8_t* yuyv = picture.luma.row(v_px) + 2 * left_px_;
      for (int column = 0; column < columns_; column += 8) {
        load_eight(yuyv + 2 * column, first + static_cast<std::size_t>(column));
      }
    } else {
      load_row(picture, row);
    }
  }
}

void SpotWindow::load_row(const Picture& picture, int row) {
  const int v_px = top_px_ + row;
  for (int column = 0; column < columns_; column += 2) {
    const std::size_t i = index(column, row);
    picture.interleaved_yuyv ? load_pair<2, 4>(picture, i, left_px_ + column, v_px)
                             : load_pair<1, 1>(picture, i, left_px_ + column, v_px);
  }
}

/// The same as four pairs, where the neighbours are known to exist. A pair is one word: Y0 U Y1 V.
void SpotWindow::load_eight(const std::uint8_t* yuyv, std::size_t i) {
  const auto pairs = loaded<Words4>(yuyv);
  const auto luma = reinterpret_cast<Shorts8>(pairs & 0x00FF00FFU);
  const Words4 red = pairs >> 24U;
  const auto own = reinterpret_cast<Shorts8>(red | red << 16U);
  const Words4 before = loaded<Words4>(yuyv - 4) >> 24U;
  const Words4 after = loaded<Words4>(yuyv + 4) >> 24U;
  const auto neighbour = reinterpret_cast<Shorts8>(before | after << 16U);
  const Shorts8 both = luma + own;
  store(strength_.data() + i, both + both + both + neighbour);
  store(luma_.data() + i, narrowed(luma));
  store(red_.data() + i, narrowed(own));
}

/// A chroma sample sits between its two pixels: V' is three parts of the own and one of the neighbour's.
template <int kLumaStep, int kRedStep>
void SpotWindow::load_pair(const Picture& picture, std::size_t i, int u_px, int v_px) {
  const int width = picture.size.width_px;
  if (u_px < 0 || u_px >= width) {
    strength_[i] = strength_[i + 1] = kOutside;
    return;
  }
  const int chroma_row = picture.chroma_rows_halved ? v_px / 2 : v_px;
  const std::uint8_t* lumas = picture.luma.row(v_px);
  const std::uint8_t* reds = picture.v.row(chroma_row);
  const int pair = u_px / 2;
  const int own = reds[pair * kRedStep];
  const int before = reds[std::max(pair - 1, 0) * kRedStep];
  const int after = reds[std::min(pair + 1, (width - 1) / 2) * kRedStep];
  const int first = lumas[u_px * kLumaStep];
  const int second = lumas[std::min(u_px + 1, width - 1) * kLumaStep];
  luma_[i] = static_cast<std::uint8_t>(first);
  luma_[i + 1] = static_cast<std::uint8_t>(second);
  red_[i] = red_[i + 1] = static_cast<std::uint8_t>(own);
  strength_[i] = static_cast<std::int16_t>(3 * (first + own) + before);
  strength_[i + 1] = u_px + 1 < width ? static_cast<std::int16_t>(3 * (second + own) + after) : kOutside;
}

}  // namespace tripoint
