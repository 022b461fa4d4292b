#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "config/tables.h"

namespace tripoint {
namespace {

constexpr std::array<ImageSize, 3> kSizes{{{320, 240}, {640, 480}, {1280, 720}}};
constexpr std::int64_t kLongestLoss_ms = 10'000;
constexpr Permitted<std::int64_t> kExposures_us{1, 1'000'000};
constexpr Permitted<std::int64_t> kGains{0, 65'535};

int integer(TableReader& table, std::string_view key, Permitted<std::int64_t> permitted, int otherwise) {
  return static_cast<int>(table.integer(key, permitted, otherwise));
}

CameraBinding binding_from(TableReader table) {
  CameraBinding binding{table.text("port", ""), table.text("serial", ""), table.text("device", "")};
  table.finish();
  return binding;
}

bool bound(const CameraBinding& binding) {
  return !binding.port.empty() || !binding.serial.empty() || !binding.device.empty();
}

void check_bindings(TableReader& table, const CamerasConfig& cameras) {
  if (cameras.source != CameraSource::kV4l2) return;
  for (const Side side : kBothSides) {
    if (!bound(cameras.bindings[side])) {
      table.refuse(name(side),
                   "names no camera: with cameras.source \"v4l2\" give its port or serial, as `tripointd cameras` "
                   "prints them, or a device");
    }
  }
}

void check_size(TableReader& table, const ImageSize& size) {
  if (std::find(kSizes.begin(), kSizes.end(), size) != kSizes.end()) return;
  table.refuse("width_px",
               fmt::format("with height_px = {} permitted is 320 x 240, 640 x 480 or 1280 x 720", size.height_px));
}

void check_exposure(TableReader& table, const ExposureSetting& setting, double rate_hz) {
  const double period_us = 1e6 / rate_hz;
  if (static_cast<double>(setting.exposure.count()) <= period_us) return;
  table.refuse("exposure_us",
               fmt::format("longer than a frame: permitted at {} Hz is up to {:.0f}", rate_hz, period_us));
}

/// Has no exposure of its own by default: the one for measuring shows no board.
std::optional<ExposureSetting> calibrating_from(TableReader& cameras, double rate_hz) {
  const bool given = cameras.has("calibrating");
  TableReader table = cameras.table("calibrating");
  if (!given) return std::nullopt;
  ExposureSetting setting;
  setting.exposure = std::chrono::microseconds{table.integer("exposure_us", kExposures_us)};
  setting.gain = integer(table, "gain", kGains, setting.gain);
  check_exposure(table, setting, rate_hz);
  table.finish();
  return setting;
}

void check_loss(TableReader& table, const CamerasConfig& cameras) {
  const double shortest_ms = 1.5e3 / cameras.rate_hz;
  if (static_cast<double>(cameras.loss_after.count()) >= shortest_ms) return;
  table.refuse("loss_after_ms",
               fmt::format("shorter than one and a half frames: permitted at {} Hz is from {:.0f} to {}",
                           cameras.rate_hz, std::ceil(shortest_ms), kLongestLoss_ms));
}

void read_leds(TableReader& table, DetectorConfig& d) {
  d.min_peak = integer(table, "min_peak", {100, 1275}, d.min_peak);
  d.min_contrast = integer(table, "min_contrast", {5, 1000}, d.min_contrast);
  d.min_emission = table.number("min_emission", {-0.2, 0.2}, d.min_emission);
}

void read_spheres(TableReader& table, DetectorConfig& d) {
  d.min_radius_px = table.number("min_radius_px", {8.0, 400.0}, d.min_radius_px);
  d.max_radius_px = table.number("max_radius_px", {8.0, 400.0}, d.max_radius_px);
  d.min_redness = table.number("min_redness", {0.1, 1.6}, d.min_redness);
  d.min_fill = table.number("min_fill", {0.3, 0.95}, d.min_fill);
  if (d.max_radius_px < d.min_radius_px) {
    table.refuse("max_radius_px", fmt::format("below min_radius_px: permitted is from {}", d.min_radius_px));
  }
}

}  // namespace

CamerasConfig cameras_from(TableReader table) {
  CamerasConfig c;
  c.source = table.choice<CameraSource>("source",
                                        {{"v4l2", CameraSource::kV4l2},
                                         {"simulation", CameraSource::kSimulation},
                                         {"recording", CameraSource::kRecording}},
                                        c.source);
  c.format = table.choice<ConfiguredFormat>(
      "format",
      {{"yuyv", ConfiguredFormat::kYuyv}, {"mjpeg", ConfiguredFormat::kMjpeg}, {"grey", ConfiguredFormat::kGrey}},
      c.format);
  c.size.width_px = integer(table, "width_px", {320, 1280}, c.size.width_px);
  c.size.height_px = integer(table, "height_px", {240, 720}, c.size.height_px);
  c.rate_hz = table.number("rate_hz", {15.0, 240.0}, c.rate_hz);
  c.measuring.exposure =
      std::chrono::microseconds{table.integer("exposure_us", kExposures_us, c.measuring.exposure.count())};
  c.measuring.gain = integer(table, "gain", kGains, c.measuring.gain);
  c.white_balance_k = integer(table, "white_balance_k", {2000, 10'000}, c.white_balance_k);
  c.focus = integer(table, "focus", {0, 65'535}, c.focus);
  c.loss_after = std::chrono::milliseconds{table.integer("loss_after_ms", {20, kLongestLoss_ms}, c.loss_after.count())};
  for (const Side side : kBothSides) c.bindings[side] = binding_from(table.table(name(side)));
  check_size(table, c.size);
  check_exposure(table, c.measuring, c.rate_hz);
  c.calibrating = calibrating_from(table, c.rate_hz);
  check_loss(table, c);
  table.finish();
  check_bindings(table, c);
  return c;
}

DetectorConfig detector_from(TableReader table) {
  DetectorConfig d;
  d.kind = table.choice<ConfiguredDetector>("kind",
                                            {{"led", ConfiguredDetector::kLed},
                                             {"sphere", ConfiguredDetector::kSphere},
                                             {"apriltag", ConfiguredDetector::kAprilTag}},
                                            d.kind);
  switch (d.kind) {
    case ConfiguredDetector::kLed:
      read_leds(table, d);
      break;
    case ConfiguredDetector::kSphere:
      read_spheres(table, d);
      break;
    case ConfiguredDetector::kAprilTag:
      d.min_margin = table.number("min_margin", {0.0, 255.0}, d.min_margin);
      break;
  }
  table.finish();
  return d;
}

SimulationConfig simulation_from(TableReader table, const std::filesystem::path& folder) {
  SimulationConfig s;
  s.scenario = table.choice<Scenario>("scenario",
                                      {{"paper-linear", Scenario::kPaperLinear},
                                       {"paper-circular", Scenario::kPaperCircular},
                                       {"scout", Scenario::kScout},
                                       {"static-volume", Scenario::kStaticVolume},
                                       {"bumped-camera", Scenario::kBumpedCamera}},
                                      s.scenario);
  s.trajectory_file = path_from(folder, table.text("trajectory_file", ""));
  s.seed = static_cast<std::uint32_t>(table.integer("seed", {0, 4'294'967'295}, s.seed));
  s.stamp_jitter_us = table.number("stamp_jitter_us", {0.0, 20'000.0}, s.stamp_jitter_us);
  s.clock_drift_ppm = table.number("clock_drift_ppm", {-1000.0, 1000.0}, s.clock_drift_ppm);
  s.right_phase_ms = table.number("right_phase_ms", {0.0, 1000.0}, s.right_phase_ms);
  s.white_level = table.number("white_level", {0.0, 10.0}, s.white_level);
  s.led_peak = table.number("led_peak", {0.0, 10'000.0}, s.led_peak);
  s.red_lamps = integer(table, "red_lamps", {0, 4}, s.red_lamps);
  s.led_lines = table.choice<SimulatedLines>("led_lines",
                                             {{"working", SimulatedLines::kWorking},
                                              {"stuck_lit", SimulatedLines::kStuckLit},
                                              {"stuck_out", SimulatedLines::kStuckOut}},
                                             s.led_lines);
  table.finish();
  return s;
}

RecordingConfig recording_from(TableReader table, const std::filesystem::path& folder, CameraSource source) {
  RecordingConfig r;
  r.folder = path_from(folder, table.text("folder", ""));
  if (source == CameraSource::kRecording && r.folder.empty()) {
    table.refuse("folder", "missing, but required with cameras.source \"recording\": permitted is a recording folder");
  }
  table.finish();
  return r;
}

}  // namespace tripoint
