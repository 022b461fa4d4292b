// The configuration as one checked value: a plain struct for each table, defaults as documented.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "values/linear.h"
#include "values/pixel.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

enum class CameraSource : std::uint8_t { kV4l2, kSimulation, kRecording };
enum class ConfiguredFormat : std::uint8_t { kYuyv, kMjpeg, kGrey };
enum class ConfiguredFrame : std::uint8_t { kReference, kLeftCamera };
enum class ConfiguredMethod : std::uint8_t { kMaximumLikelihood, kPaper };
enum class ConfiguredDetector : std::uint8_t { kLed, kSphere, kAprilTag };
enum class ModulationLines : std::uint8_t { kSimulated };
enum class SimulatedLines : std::uint8_t { kWorking, kStuckLit, kStuckOut };
enum class Scenario : std::uint8_t { kPaperLinear, kPaperCircular, kScout, kStaticVolume, kBumpedCamera };

/// Which camera is the left or the right one; "" = not asked for. `device` overrides both.
struct CameraBinding {
  std::string port;  ///< USB port path
  std::string serial;
  std::string device;  ///< /dev/videoN
};

/// What makes a camera's picture lighter or darker.
struct ExposureSetting {
  std::chrono::microseconds exposure{2000};
  int gain = 0;  ///< in the camera's own unit
  friend bool operator==(const ExposureSetting&, const ExposureSetting&) = default;
};

struct CamerasConfig {
  CameraSource source = CameraSource::kV4l2;
  ConfiguredFormat format = ConfiguredFormat::kYuyv;
  ImageSize size{640, 480};
  double rate_hz = 30.0;
  ExposureSetting measuring;                   ///< exposure_us and gain
  std::optional<ExposureSetting> calibrating;  ///< for pictures of a calibration board; nothing measured depends on it
  int white_balance_k = 4500;
  int focus = 0;
  std::chrono::milliseconds loss_after{100};
  PerSide<CameraBinding> bindings;
};

struct RecordingConfig {
  std::filesystem::path folder;
};

/// The names and units of LedDetectorSettings, SphereSettings and TagDetectorSettings; those of the kind are read.
struct DetectorConfig {
  ConfiguredDetector kind = ConfiguredDetector::kLed;
  int min_peak = 780;
  int min_contrast = 45;
  double min_emission = 0.0;
  double min_radius_px = 10.0;
  double max_radius_px = 120.0;
  double min_redness = 0.4;
  double min_fill = 0.5;
  double min_margin = 25.0;
};

/// The working volume in the output frame.
struct VolumeConfig {
  Vec3 min_mm = Vec3::Zero();
  Vec3 max_mm = Vec3::Zero();
};

/// A fixed LED that watches the mount, in the reference frame whatever output.frame says.
struct DatumConfig {
  Vec3 position_mm = Vec3::Zero();
  double uncertainty_mm = 0.0;  ///< k = 2, along each axis
  double radius_mm = 0.0;       ///< a light so near is taken for it
};

struct TimingConfig {
  double offset_prior_ms = 10.0;
  double bound_mm = 1.0;
  double line_time_us = 0.0;
};

struct OutputConfig {
  ConfiguredFrame frame = ConfiguredFrame::kReference;
  ConfiguredMethod method = ConfiguredMethod::kMaximumLikelihood;
  std::chrono::milliseconds age_limit{200};
  std::chrono::milliseconds latch_hold{10'000};
  double settled_mm_per_s = 5.0;
};

struct ModbusConfig {
  std::string address = "127.0.0.1";
  std::uint16_t port = 1502;
  std::vector<std::string> command_clients;  ///< addresses or networks a.b.c.d/n; empty: nobody may write
  std::vector<std::string> allowed_clients;  ///< empty: everyone
  int max_connections = 64;
  std::uint32_t serial_number = 0;
};

/// LEDs that lines switch, one for each point of the target.
struct ModulationConfig {
  bool enabled = false;
  ModulationLines lines = ModulationLines::kSimulated;
  double stamp_error_ms = 3.0;  ///< how wrong a camera's stamp may be against the clock by which the lines are switched
};

struct SimulationConfig {
  Scenario scenario = Scenario::kPaperCircular;
  std::filesystem::path trajectory_file;  ///< when not empty, instead of the scenario
  std::uint32_t seed = 1;
  double stamp_jitter_us = 0.0;
  double clock_drift_ppm = 0.0;
  double right_phase_ms = 0.0;  ///< how much later the right camera exposes
  double led_peak = 1.5;        ///< times clip at 400 mm, with an exposure of 2000 us and gain 0
  double white_level = 0.05;    ///< of a white surface, likewise
  int red_lamps = 0;            ///< that stand about, in the LED's size and colour
  SimulatedLines led_lines = SimulatedLines::kWorking;  ///< what the lines of modulation do
};

struct Config {
  CamerasConfig cameras;
  std::filesystem::path calibration_file;  ///< empty: measures nothing, fault 0
  RecordingConfig recording;
  DetectorConfig detector;
  std::filesystem::path target_file;  ///< empty: one LED at the origin
  VolumeConfig volume;
  std::optional<DatumConfig> datum;
  TimingConfig timing;
  OutputConfig output;
  ModulationConfig modulation;
  ModbusConfig modbus;
  SimulationConfig simulation;
  std::vector<std::string> values;  ///< "table.key = value" of everything above, sorted; paths as written
  std::vector<std::pair<std::string, std::string>> places;  ///< "table.key" and "file:line" of what the file gives
  std::uint32_t id = 0;                                     ///< registers 16-17
};

/// Checks the whole text. Relative paths are taken from the folder of `file_name`.
///
/// @param overrides "table.key=value" each, from the command line; values of text need no quotes
/// @return kMalformed, kUnknownKey, kMissingKey or kOutOfRange naming file, line, key and what is permitted
Result<Config> parse_config(std::string_view text, std::string_view file_name, std::span<const std::string> overrides);

/// @return kCannotRead, or as parse_config
Result<Config> load_config(const std::filesystem::path& path, std::span<const std::string> overrides);

/// An error of what a value of the configuration names (a file, a folder), told with the place and key of that value.
Error named_by(const Config& config, std::string_view key, const Error& error);

/// The same text for every way of writing the same values of these tables: what a hash is made of. For the setup
/// (register 146) the tables are kSetupTables; the source is cameras.source. [cameras.calibrating] is left out: nothing
/// is measured with it.
std::string canonical_text(const Config& config, std::span<const std::string_view> tables);
inline constexpr std::array<std::string_view, 6> kSetupTables{"cameras", "detector",   "timing",
                                                              "output",  "modulation", "datum"};

}  // namespace tripoint
