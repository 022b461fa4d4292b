// [detector] of the configuration as the detector's own settings.
#pragma once

#include "config/config.h"
#include "line/detect/settings.h"

namespace tripoint {

LedDetectorSettings led_detector_settings(const DetectorConfig& config);

}  // namespace tripoint
