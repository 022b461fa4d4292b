#include "app/latency.h"

#include <algorithm>
#include <cmath>

namespace tripoint {

void LatencyWindow::add(Duration latency) {
  samples_[next_] = latency;
  next_ = (next_ + 1) % kSize;
  count_ = std::min(count_ + 1, kSize);
}

Duration LatencyWindow::quantile(double p) const {
  if (count_ == 0) return Duration{0};
  std::array<Duration, kSize> sorted = samples_;
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(count_)));
  const std::size_t index = std::clamp<std::size_t>(rank, 1, count_) - 1;
  Duration* const first = sorted.data();
  std::nth_element(first, first + index, first + count_);
  return sorted[index];
}

}  // namespace tripoint
