// What two open cameras show of the target's LEDs.
#pragma once

#include <cstddef>

#include "app/camera_pair.h"
#include "app/exposure_search.h"

namespace tripoint {

/// The medians over some pictures.
///
/// @param leds  so many LEDs the target has
/// @return errors of CameraPair::watch
Result<Look> look_at_leds(const CameraPair& cameras, const DetectorConfig& detector, std::size_t leds);

}  // namespace tripoint
