// Everything that the unit tells its clients, as the composition publishes it: one value, whole, never changed after.
#pragma once

#include <cstdint>
#include <optional>

#include "contract/registers.h"
#include "line/measurement.h"
#include "line/model.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

struct FirmwareVersion {
  std::uint16_t major = 0;
  std::uint16_t minor = 0;
  std::uint16_t patch = 0;
};

/// Registers 8 to 18 and 146.
struct UnitIdentity {
  std::uint32_t serial_number = 0;
  FirmwareVersion firmware;
  registers::Mode mode = registers::Mode::kLedPosition;
  std::uint32_t calibration_id = 0;  ///< first 32 bits of its SHA-256, 0 = none
  std::uint32_t configuration_id = 0;
  OutputFrame output_frame = OutputFrame::kReference;
  std::uint16_t setup = 1;  ///< never 0
};

/// What the status bits say about the unit, not about one pose.
struct UnitFlags {
  bool ready = false;  ///< calibrated, both cameras deliver
  bool calibrated = false;
  bool registered = false;  ///< to the robot base
  bool clock_synchronised = false;
  bool simulated = true;  ///< simulation or recording; must be cleared on purpose
  bool verified = false;  ///< the calibration, by a length
};

/// The newest verdict of the line with what belongs to this very moment.
struct PublishedMeasurement {
  Measurement measurement;
  Duration utc_offset{0};  ///< added to a monotonic time: nanoseconds since 1970 UTC, at publication
};

/// Registers 700 to 715 and 716 to 731; absent = unknown.
struct CameraStats {
  registers::CameraState state = registers::CameraState::kMissing;
  double frames_per_second = 0.0;
  std::optional<double> exposure_us;
  std::optional<double> gain;
  std::optional<double> temperature_degc;
  std::uint32_t dropped = 0;
  std::uint16_t spots = 0;
  std::optional<double> spot_peak;   ///< luma steps
  std::optional<double> image_mean;  ///< luma steps
  std::optional<double> focus_per_px;
  std::optional<double> above_dim;  ///< factors of light, 1 = at the limit: ExposureMargin
  std::optional<double> below_clipping;
  std::uint16_t resets = 0;
};

/// Registers 738 to 746 that no measurement carries; absent = unknown.
struct HealthStats {
  std::optional<double> latency_p50_us;
  std::optional<double> latency_p99_us;
  std::optional<double> cpu_temperature_degc;
  std::optional<double> load_percent;
};

/// The limits of [output] that are decided while answering.
struct OutputLimits {
  Duration age_limit{200'000'000};
  Duration latch_hold{10'000'000'000};
};

struct UnitState {
  UnitIdentity identity;
  UnitFlags flags;
  OutputLimits limits;
  registers::State state = registers::State::kStarting;
  TimePoint started{};
  std::uint16_t heartbeat = 0;
  Faults faults;      ///< of the unit; those of the measurement are added
  Warnings warnings;  ///< of the unit; those of the measurement are added, Publication holds all
  std::optional<PublishedMeasurement> newest;  ///< nothing before the first verdict
  bool exposure_since_start = false;           ///< at least one verdict was about pictures, not about a camera
  bool pose_since_start = false;               ///< at least one verdict had a pose
  PerSide<CameraStats> cameras;
  HealthStats health;
};

}  // namespace tripoint
