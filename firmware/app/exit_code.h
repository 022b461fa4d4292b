// How the program ends; scripts and service managers rely on the numbers.
#pragma once

#include "values/result.h"

namespace tripoint {

enum class ExitCode : int {
  kWell = 0,
  kNo = 1,             ///< looked at what it was asked to, and the verdict is no
  kUsage = 2,          ///< usage, configuration, a port in use, or an output that cannot be written
  kDeviceMissing = 3,  ///< never from `run`, which waits for it
  kOurFault = 70,
};

constexpr int number(ExitCode code) { return static_cast<int>(code); }

/// Prints the error's line to stderr and says how to end.
int report(const Error& error);

/// To be called last: writes out what stdout still holds. `code`, unless the output could not be written: that is
/// reported to stderr and ends with kUsage.
int code_with_output_written(int code);

}  // namespace tripoint
