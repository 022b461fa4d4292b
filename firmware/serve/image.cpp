#include "serve/image.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "serve/pose_blocks.h"
#include "serve/reading.h"

namespace tripoint {
namespace {

void put_identity(RegisterImage& image, const UnitIdentity& identity) {
  using namespace registers::identity;
  image.put(kMagic, kMagicValue);
  image.put(kMapMajor, kMapMajorValue);
  image.put(kMapMinor, kMapMinorValue);
  image.put(kImageLength, kImageLengthValue);
  image.put(kWordOrderInteger, kWordOrderIntegerValue);
  image.put(kWordOrderFloat, kWordOrderFloatValue);
  image.put(kSerialNumber, identity.serial_number);
  image.put(kFirmwareMajor, identity.firmware.major);
  image.put(kFirmwareMinor, identity.firmware.minor);
  image.put(kFirmwarePatch, identity.firmware.patch);
  image.put(kMode, identity.mode);
  image.put(kCalibrationId, identity.calibration_id);
  image.put(kConfigurationId, identity.configuration_id);
  image.put(kOutputFrame, identity.output_frame);
}

/// The status bits now: those of the newest measurement, and degraded also by a warning that is held.
std::uint16_t status_now(const Reading& live, std::uint16_t warnings) {
  constexpr unsigned kDegraded = 1U << static_cast<unsigned>(registers::StatusBit::kDegraded);
  return static_cast<std::uint16_t>(live.status | (warnings != 0 ? kDegraded : 0U));
}

void put_state(RegisterImage& image, const Edition& edition, const ServiceState& service, const Reading& live) {
  using namespace registers::state;
  const UnitState& state = *edition.state;
  const auto warnings = static_cast<std::uint16_t>(live.warnings | edition.held.bits() | service.warnings.bits());
  image.put(kHeartbeat, state.heartbeat);
  image.put(kStatus, status_now(live, warnings));
  image.put(kFaults, live.faults);
  image.put(kWarnings, warnings);
  image.put(kState, state.state);
  image.put(kClients, service.clients);
  image.put(kCommandEcho, service.command.echo);
  image.put(kCommandState, service.command.state);
  image.put(kCommandResult, service.command.result);
  image.put(kCommandDetail, service.command.detail);
}

/// Expanded uncertainty (k = 2) in the direction in which it is largest.
std::optional<double> largest_expanded_mm(const Matrix3& covariance_mm2) {
  if (!covariance_mm2.allFinite()) return std::nullopt;
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(covariance_mm2, Eigen::EigenvaluesOnly);
  return 2.0 * std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

void put_point(RegisterImage& image, const MeasuredPoint* point, std::size_t shift) {
  using namespace registers::points;
  const auto coordinate = [&](int i) { return point ? std::optional<double>(point->in_output_mm[i]) : std::nullopt; };
  image.put(kX, coordinate(0), shift);
  image.put(kY, coordinate(1), shift);
  image.put(kZ, coordinate(2), shift);
  image.put(kUncertainty, point ? largest_expanded_mm(point->covariance_mm2) : std::nullopt, shift);
  image.put(kResidual, point ? std::optional<double>(point->residual_px) : std::nullopt, shift);
  if (point == nullptr) return;
  image.put(kId, static_cast<std::uint16_t>(std::clamp(point->id, 0, 0xFFFF)), shift);
  const unsigned flags = (point->saturated ? 1U << static_cast<unsigned>(registers::PointBit::kSaturated) : 0U) |
                         (point->weak ? 1U << static_cast<unsigned>(registers::PointBit::kWeak) : 0U);
  image.put(kFlags, static_cast<std::uint16_t>(flags), shift);
}

void put_points(RegisterImage& image, const UnitState& state, const Reading& live) {
  using namespace registers::points;
  constexpr std::size_t kStride = 10;
  const bool shown = state.newest && !live.has(registers::StatusBit::kStale);
  const std::size_t count = shown ? state.newest->measurement.points.size() : 0;
  image.put(kSequence, static_cast<std::uint16_t>(live.sequence));
  image.put(kCount, static_cast<std::uint16_t>(count));
  for (std::size_t i = 0; i < kMaxTargetPoints; ++i) {
    put_point(image, i < count ? &state.newest->measurement.points[i] : nullptr, i * kStride);
  }
  image.put(kSequenceEnd, static_cast<std::uint16_t>(live.sequence));
}

void put_camera(RegisterImage& image, const CameraStats& stats, std::size_t shift) {
  using namespace registers::left_camera;
  image.put(kState, stats.state, shift);
  image.put(kFramesPerSecond, registers::raw_of(kFramesPerSecond, stats.frames_per_second), shift);
  image.put(kExposure, stats.exposure_us, shift);
  image.put(kGain, stats.gain, shift);
  image.put(kTemperature, stats.temperature_degc, shift);
  image.put(kDropped, stats.dropped, shift);
  image.put(kSpots, stats.spots, shift);
  image.put(kSpotPeak, stats.spot_peak, shift);
  image.put(kImageMean, stats.image_mean, shift);
  image.put(kFocus, stats.focus_per_px, shift);
  image.put(kResets, stats.resets, shift);
  image.put(kAboveDim, stats.above_dim, shift);
  image.put(kBelowClipping, stats.below_clipping, shift);
}

void put_timing(RegisterImage& image, const UnitState& state) {
  using namespace registers::timing;
  std::optional<double> skew_us, skew_expanded_us, cost_mm, epipolar_px, side_error_mm, decalibration_mm;
  if (state.newest && state.newest->measurement.common_time) {
    const Timing& timing = state.newest->measurement.timing;
    skew_us = 1e6 * timing.skew_s;
    skew_expanded_us = 2e6 * timing.skew_sigma_s;
    cost_mm = timing.uncorrected_cost_mm;
  }
  if (state.newest && !state.newest->measurement.points.empty()) {
    epipolar_px = state.newest->measurement.epipolar_rms_px;
  }
  if (state.newest) {
    side_error_mm = state.newest->measurement.side_length_error_mm;
    decalibration_mm = state.newest->measurement.decalibration_mm;
  }
  image.put(kSkew, skew_us);
  image.put(kSkewUncertainty, skew_expanded_us);
  image.put(kSkewCost, cost_mm);
  image.put(kLatencyP50, state.health.latency_p50_us);
  image.put(kLatencyP99, state.health.latency_p99_us);
  image.put(kEpipolarRms, epipolar_px);
  image.put(kSideLengthError, side_error_mm);
  image.put(kDecalibration, decalibration_mm);
  image.put(kCpuTemperature, state.health.cpu_temperature_degc);
  image.put(kLoad, state.health.load_percent);
}

/// Prediction to the moment of the answer does not exist yet: the block names its cause and time, and no pose.
Reading without_prediction(const Reading& live) {
  Reading reading = without_pose(live);
  reading.age_ms.reset();
  return reading;
}

}  // namespace

RegisterImage image_at(const Edition& edition, const ServiceState& service, TimePoint now) {
  using namespace registers;
  const UnitState& state = *edition.state;
  const Reading live = live_reading(state, edition.latch, now);
  const Reading latched_copy = latched_reading(state, edition.latch, now);

  RegisterImage image;
  put_identity(image, state.identity);
  put_state(image, edition, service, live);
  image.put(registers::state::kUptime, raw_of(registers::state::kUptime, std::floor(seconds(now - state.started))));
  put_integer_pose(image, live);
  put_float_pose(image, live);
  put_float_pose(image, without_prediction(live), predicted::kFirst - measured_float::kFirst);
  put_single_pose(image, live);
  put_integer_pose(image, latched_copy, latched::kFirst - measured::kFirst);
  put_single_pose(image, latched_copy, latched_single::kFirst - single::kFirst);
  put_points(image, state, live);
  put_camera(image, state.cameras.left, 0);
  put_camera(image, state.cameras.right, right_camera::kFirst - left_camera::kFirst);
  put_timing(image, state);
  return image;
}

}  // namespace tripoint
