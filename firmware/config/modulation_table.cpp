#include <fmt/format.h>

#include "config/tables.h"

namespace tripoint {
namespace {

constexpr double kSlowest_hz = 30.0;  // pictures of lit LEDs are up to two periods apart, which may be 80 ms at most

/// Both cameras' exposures, and what their stamps may be wrong by, must leave a moment between them.
double longest_stamp_error_ms(const CamerasConfig& cameras) {
  const double period_ms = 1e3 / cameras.rate_hz;
  const double exposure_ms = 1e-3 * static_cast<double>(cameras.measuring.exposure.count());
  return 0.5 * (0.5 * period_ms - exposure_ms);
}

void check_detector(TableReader& table, const DetectorConfig& detector) {
  if (detector.kind == ConfiguredDetector::kLed) return;
  table.refuse("enabled", "only LEDs can be switched: permitted with a detector.kind other than \"led\" is false");
}

/// A line that nobody switches must not look like one.
void check_source(TableReader& table, CameraSource source) {
  if (source == CameraSource::kSimulation) return;
  table.refuse(
      "enabled",
      "this version can only switch simulated lines: permitted with cameras.source \"v4l2\" or \"recording\" is "
      "false");
}

void check_timing(TableReader& table, const ModulationConfig& modulation, const CamerasConfig& cameras) {
  if (cameras.rate_hz < kSlowest_hz) {
    table.refuse("enabled",
                 fmt::format("pictures of lit LEDs would lie too far apart: permitted is cameras.rate_hz from "
                             "{:.0f}",
                             kSlowest_hz));
    return;
  }
  const double longest_ms = longest_stamp_error_ms(cameras);
  if (longest_ms <= 0.0) {
    table.refuse("enabled", fmt::format("the exposures of both cameras leave no time to switch between them: permitted "
                                        "is cameras.exposure_us below {:.0f}",
                                        0.5e6 / cameras.rate_hz));
  } else if (modulation.stamp_error_ms >= longest_ms) {
    table.refuse("stamp_error_ms",
                 fmt::format("no time is left to switch between the exposures of both cameras: permitted with this "
                             "cameras.exposure_us and rate_hz is below {:.2f}",
                             longest_ms));
  }
}

}  // namespace

ModulationConfig modulation_from(TableReader table, const Config& config) {
  ModulationConfig m;
  m.enabled = table.truth("enabled", m.enabled);
  m.lines = table.choice<ModulationLines>("lines", {{"simulated", ModulationLines::kSimulated}}, m.lines);
  m.stamp_error_ms = table.number("stamp_error_ms", {0.0, 100.0}, m.stamp_error_ms);
  table.finish();
  if (!m.enabled) return m;
  check_detector(table, config.detector);
  check_source(table, config.cameras.source);
  check_timing(table, m, config.cameras);
  return m;
}

}  // namespace tripoint
