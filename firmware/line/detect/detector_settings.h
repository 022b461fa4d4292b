// The settings of whichever detector is chosen.
#pragma once

#include <variant>

#include "line/detect/settings.h"
#include "line/detect/sphere_settings.h"

namespace tripoint {

using DetectorSettings = std::variant<LedDetectorSettings, SphereSettings>;

}  // namespace tripoint
