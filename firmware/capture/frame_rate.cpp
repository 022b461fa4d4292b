#include "capture/frame_rate.h"

namespace tripoint {

void FrameRate::take(TimePoint arrival) {
  if (!started_) {
    started_ = true;
    window_start_ = arrival;
    return;
  }
  ++frames_;
  const Duration elapsed = arrival - window_start_;
  if (elapsed < std::chrono::seconds(1)) return;
  rate_hz_ = frames_ / seconds(elapsed);
  window_start_ = arrival;
  frames_ = 0;
}

}  // namespace tripoint
