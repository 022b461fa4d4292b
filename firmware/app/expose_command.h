// `tripointd expose --config FILE`: finds exposure and gain, and writes them where it was asked to.
#pragma once

#include "app/exposing.h"

namespace tripoint {

/// For measuring it looks at the target at the near and at the far end of the working volume. An operator holds it
/// there and presses Enter; simulated cameras see it held there. For calibrating: expose_for_calibrating.
///
/// @return 0; 1 when nothing suits or the check in a fresh picture fails; 3 when a camera is missing, in use, or stops
///   in the middle; otherwise as report()
int expose_command(const ExposeOptions& options);

}  // namespace tripoint
