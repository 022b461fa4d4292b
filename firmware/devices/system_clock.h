// The operating system's clocks.
#pragma once

#include "ports/clock.h"

namespace tripoint {

/// CLOCK_MONOTONIC for measuring, CLOCK_REALTIME for what the wall clock says, the kernel's word for whether to trust
/// it.
class SystemClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override;
  /// Read anew each time: the wall clock may be set or slewed while the program runs.
  [[nodiscard]] Duration utc_offset() const override;
  [[nodiscard]] bool synchronised() const override;
};

}  // namespace tripoint
