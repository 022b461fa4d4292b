// `tripointd expose --config FILE`: finds exposure and gain, and writes them where it was asked to.
#pragma once

#include <cstddef>
#include <functional>

#include "app/exposing.h"
#include "capture/camera_worker.h"
#include "config/config.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// For measuring it looks at the target at the near and at the far end of the working volume. An operator holds it
/// there and presses Enter; simulated cameras see it held there. For calibrating: expose_for_calibrating.
///
/// @return 0; 1 when nothing suits or the check in a fresh picture fails; 3 when a camera is missing, in use, or stops
///   in the middle; otherwise as report()
int expose_command(const ExposeOptions& options);

/// How to open the cameras while the target is held at this depth of the reference frame.
using CamerasAt = std::function<Result<PerSide<OpenCamera>>(const Config& config, double z_mm)>;

/// The part of expose_command that looks at the target.
///
/// @param leds  of the target
/// @return as expose_command
int expose_for_measuring(const ExposeOptions& options, const Config& config, std::size_t leds,
                         const CamerasAt& cameras);

}  // namespace tripoint
