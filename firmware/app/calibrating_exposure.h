// Finds exposure and gain for pictures of a calibration board.
#pragma once

#include "app/exposing.h"
#include "config/config.h"

namespace tripoint {

/// Looks at a board that an operator holds before both cameras; simulated cameras see one held in the middle of the
/// working volume. The setting is checked in fresh pictures, and then written as [cameras.calibrating].
///
/// @return as expose_command
int expose_for_calibrating(const ExposeOptions& options, const Config& config);

}  // namespace tripoint
