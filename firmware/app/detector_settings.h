// [detector] of the configuration as the detector's own settings.
#pragma once

#include "config/config.h"
#include "line/detect/detector_settings.h"

namespace tripoint {

LedDetectorSettings led_detector_settings(const DetectorConfig& config);
SphereSettings sphere_settings(const DetectorConfig& config);
/// Of the detector that is chosen.
DetectorSettings detector_settings(const DetectorConfig& config);

}  // namespace tripoint
