#include "app/detector_settings.h"

namespace tripoint {

LedDetectorSettings led_detector_settings(const DetectorConfig& config) {
  LedDetectorSettings settings;
  settings.min_peak = config.min_peak;
  settings.min_contrast = config.min_contrast;
  settings.min_emission = config.min_emission;
  return settings;
}

}  // namespace tripoint
