// An output that switches one LED: what simulated lines are, and lines of a GPIO chip can be.
#pragma once

#include "values/result.h"

namespace tripoint {

class SwitchedLine {
 public:
  SwitchedLine() = default;
  SwitchedLine(const SwitchedLine&) = delete;
  SwitchedLine& operator=(const SwitchedLine&) = delete;
  virtual ~SwitchedLine() = default;

  /// When this returns, the LED is lit or out as asked; in between it may be either.
  ///
  /// @return kDeviceMissing, kDeviceFault: the LED may be in either state, until a later call succeeds
  virtual Result<void> set(bool lit) = 0;
};

}  // namespace tripoint
