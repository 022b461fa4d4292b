#include "tags/luma_copy.h"

#include <algorithm>
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

LumaView LumaCopy::view() const {
  return {{.data = values_.data(), .stride_bytes = static_cast<std::size_t>(size_.width_px), .step_bytes = 1}, size_};
}

}  // namespace tripoint
