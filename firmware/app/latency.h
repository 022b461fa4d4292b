// How long answers take: percentiles of the newest durations.
#pragma once

#include <array>
#include <cstddef>

#include "values/time.h"

namespace tripoint {

/// Keeps the newest 1024 durations (about 20 s of verdicts at 50 a second).
class LatencyWindow {
 public:
  void add(Duration latency);

  /// The p-quantile (0 to 1) of what the window holds, by nearest rank; 0 while it is empty.
  [[nodiscard]] Duration quantile(double p) const;

 private:
  static constexpr std::size_t kSize = 1024;

  std::array<Duration, kSize> samples_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace tripoint
