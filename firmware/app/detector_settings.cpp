#include "app/detector_settings.h"

namespace tripoint {

LedDetectorSettings led_detector_settings(const DetectorConfig& config) {
  LedDetectorSettings settings;
  settings.min_peak = config.min_peak;
  settings.min_contrast = config.min_contrast;
  settings.min_emission = config.min_emission;
  return settings;
}

SphereSettings sphere_settings(const DetectorConfig& config) {
  SphereSettings settings;
  settings.min_radius_px = config.min_radius_px;
  settings.max_radius_px = config.max_radius_px;
  settings.min_redness = config.min_redness;
  settings.min_fill = config.min_fill;
  return settings;
}

DetectorSettings detector_settings(const DetectorConfig& config) {
  if (config.kind == ConfiguredDetector::kSphere) return sphere_settings(config);
  return led_detector_settings(config);
}

}  // namespace tripoint
