// The configuration: one TOML file, parsed once, checked whole, passed on by piece.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "values/linear.h"
#include "values/pixel.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

enum class CameraSource : std::uint8_t { kV4l2, kSimulation, kRecording };
enum class CameraFormat : std::uint8_t { kYuyv, kMjpeg, kGrey };
enum class FrameOfOutput : std::uint8_t { kReference, kLeftCamera };
enum class PoseMethod : std::uint8_t { kMaximumLikelihood, kPaper };

/// How the unit finds one camera; empty = not used. At least one must be given for "v4l2".
struct CameraBinding {
  std::string port;    ///< USB port path, "1-1.2"
  std::string serial;
  std::string device;  ///< "/dev/video0", for machines where neither helps
};

struct CamerasConfig {
  CameraSource source = CameraSource::kV4l2;
  CameraFormat format = CameraFormat::kYuyv;
  ImageSize size{.width_px = 640, .height_px = 480};
  double rate_hz = 30.0;
  int exposure_us = 2000;
  int gain = 0;
  int white_balance_k = 4500;
  int focus = 0;
  int loss_after_ms = 100;
  PerSide<CameraBinding> binding;
};

struct DetectorConfig {
  std::string kind = "led";
};

struct TimingConfig {
  double offset_prior_ms = 10.0;  ///< standard deviation of the unknown offset between the cameras' stamps
  double bound_mm = 1.0;          ///< what time may contribute (standard deviation); above it fault 9
  double line_time_us = 0.0;      ///< rolling shutter: time from row to row
};

struct OutputConfig {
  FrameOfOutput frame = FrameOfOutput::kReference;
  PoseMethod method = PoseMethod::kMaximumLikelihood;
  int age_limit_ms = 200;
  int latch_hold_ms = 10000;
  double settled_mm_per_s = 5.0;
};

struct ModbusConfig {
  std::string address = "127.0.0.1";
  std::uint16_t port = 1502;
  std::vector<std::string> command_clients;  ///< addresses or networks that may write the command word
  std::vector<std::string> allowed_clients;  ///< empty: everyone may read
  int max_connections = 64;
  std::uint32_t serial_number = 0;
};

struct SimulationConfig {
  std::string scenario = "paper-circular";
  std::filesystem::path trajectory_file;  ///< overrides the scenario
  std::uint64_t seed = 1;
  double stamp_jitter_us = 0.0;
  double clock_drift_ppm = 0.0;  ///< left slow, right fast by half of it each
  double right_phase_ms = 0.0;   ///< the right camera exposes so much later
};

struct VolumeConfig {
  Vec3 min_mm = Vec3::Zero();
  Vec3 max_mm = Vec3::Zero();
};

struct RecordingConfig {
  std::filesystem::path folder;
  bool paced = true;
};

struct Config {
  CamerasConfig cameras;
  std::filesystem::path calibration_file;  ///< empty: nothing is measured
  RecordingConfig recording;
  DetectorConfig detector;
  std::filesystem::path target_file;  ///< empty: one LED at the target's origin
  VolumeConfig volume;
  TimingConfig timing;
  OutputConfig output;
  ModbusConfig modbus;
  SimulationConfig simulation;

  std::array<std::uint8_t, 32> sha256{};  ///< over everything
  std::string setup_text;                 ///< the part that register 146 speaks of, in a canonical form
};

/// @param overrides  "table.key=value" from the command line, applied before checking
/// @return kMalformed, kUnknownKey, kMissingKey or kOutOfRange; the message names file, line, key and permitted range.
///   Relative file names are relative to the configuration file's folder.
Result<Config> parse_config(std::string_view text, const std::filesystem::path& file,
                            const std::vector<std::string>& overrides);

/// @return kCannotRead, or as parse_config
Result<Config> load_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace tripoint
