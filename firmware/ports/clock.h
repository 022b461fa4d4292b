// Clock and waiting as values passed in, so that a test never reads the wall clock and never sleeps.
#pragma once

#include <functional>

#include "values/time.h"

namespace tripoint {

class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  [[nodiscard]] virtual TimePoint now() const = 0;
  /// What to add to a monotonic time to get nanoseconds since 1970 UTC.
  [[nodiscard]] virtual Duration utc_offset() const = 0;
  /// True when the operating system says that its wall clock is synchronised.
  [[nodiscard]] virtual bool synchronised() const = 0;
};

/// Waits until the clock shows this time.
using WaitUntil = std::function<void(TimePoint)>;

}  // namespace tripoint
