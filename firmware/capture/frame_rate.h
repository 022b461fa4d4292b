// Frames per second as they arrive, over about a second.
#pragma once

#include "values/time.h"

namespace tripoint {

class FrameRate {
 public:
  void take(TimePoint arrival);
  void restart() { *this = FrameRate{}; }
  /// 0 until the first second is over.
  [[nodiscard]] double rate_hz() const { return rate_hz_; }

 private:
  TimePoint window_start_{};
  int frames_ = 0;  // since the window's first, which is not counted
  bool started_ = false;
  double rate_hz_ = 0.0;
};

}  // namespace tripoint
