#include "tags/luma_copy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "values/assert.h"

namespace tripoint {

void LumaCopy::take(const Picture& picture) {
  TRIPOINT_ASSERT(picture.bands.empty());
  size_ = picture.size;
  const auto width = static_cast<std::size_t>(size_.width_px);
  values_.resize(width * static_cast<std::size_t>(size_.height_px));
  std::uint8_t* to = values_.data();
  for (int y = 0; y < size_.height_px; ++y, to += width) {
    const std::uint8_t* from = picture.luma.row(y);
    if (picture.luma.step_bytes == 1) {
      std::copy_n(from, width, to);
    } else {
      for (std::size_t x = 0; x < width; ++x) to[x] = from[x * picture.luma.step_bytes];
    }
  }
}

double LumaCopy::mean() const {
  const auto sum = std::accumulate(values_.begin(), values_.end(), std::uint64_t{0});
  return values_.empty() ? 0.0 : static_cast<double>(sum) / static_cast<double>(values_.size());
}

std::optional<double> LumaCopy::at(const Vec2& place_px) const {
  const double left = std::floor(place_px.x());
  const double top = std::floor(place_px.y());
  if (!(left >= 0.0 && top >= 0.0 && left + 1.0 < size_.width_px && top + 1.0 < size_.height_px)) return std::nullopt;
  const double right_share = place_px.x() - left;
  const double lower_share = place_px.y() - top;
  const auto width = static_cast<std::size_t>(size_.width_px);
  const std::uint8_t* upper = values_.data() + static_cast<std::size_t>(top) * width + static_cast<std::size_t>(left);
  const std::uint8_t* lower = upper + width;
  const double above = upper[0] + right_share * (upper[1] - upper[0]);
  const double below = lower[0] + right_share * (lower[1] - lower[0]);
  return above + lower_share * (below - above);
}

}  // namespace tripoint
