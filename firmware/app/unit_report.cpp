#include "app/unit_report.h"

#include <algorithm>
#include <limits>

#include "line/detect/exposure_margin.h"

namespace tripoint {
namespace {

template <typename Unsigned>
Unsigned clipped(std::uint64_t value) {
  return static_cast<Unsigned>(std::min<std::uint64_t>(value, std::numeric_limits<Unsigned>::max()));
}

/// Of the target's points; of everything found as long as none is identified.
std::optional<ExposureMargin> margin_of(const Measurement& measurement, Side side) {
  std::optional<double> dimmest_luma;
  double brightest_luma = 0.0;
  for (const MeasuredPoint& point : measurement.points) {
    if (point.id == 0) continue;
    const double luma = point.peak_luma[side];
    dimmest_luma = std::min(dimmest_luma.value_or(luma), luma);
    brightest_luma = std::max(brightest_luma, luma);
  }
  if (dimmest_luma) return exposure_margin(*dimmest_luma, brightest_luma);
  const ImageHealth& health = measurement.health[side];
  if (measurement.spots[side] == 0 || health.peak_luma <= 0.0) return std::nullopt;
  return exposure_margin(health.dimmest_luma, health.peak_luma);
}

double microseconds(Duration duration) { return std::chrono::duration<double, std::micro>(duration).count(); }

/// A camera that was never there is missing; one that is not there any more as well.
registers::CameraState camera_state(const CameraStatus& camera) {
  if (camera.delivering) return registers::CameraState::kDelivering;
  return camera.losses == 0 ? registers::CameraState::kStarting : registers::CameraState::kMissing;
}

}  // namespace

UnitReport::UnitReport(const UnitConstants& constants, TimePoint started) : constants_(constants), started_(started) {}

void UnitReport::take(const Measurement& measurement, std::optional<TimePoint> arrived, const Clock& clock) {
  if (measurement.common_time) {
    ++heartbeat_;
    exposure_since_start_ = true;
  }
  if (measurement.pose) pose_since_start_ = true;
  newest_ = PublishedMeasurement{.measurement = measurement, .utc_offset = clock.utc_offset()};
  if (arrived && measurement.common_time) latency_.add(clock.now() - *arrived);
}

void UnitReport::withdraw_pose(Fault cause) {
  if (!newest_) return;
  Measurement& measurement = newest_->measurement;
  measurement.faults.insert(cause);
  measurement.pose.reset();
  measurement.points.clear();
  measurement.timing.settled = false;
  measurement.mount_watched = false;
}

UnitState UnitReport::state(const PerSide<CameraStatus>& cameras, const Clock& clock) const {
  UnitState state;
  state.identity = constants_.identity;
  state.limits = constants_.limits;
  state.flags.calibrated = constants_.calibrated;
  state.flags.ready = !stopped_ && constants_.calibrated && cameras.left.delivering && cameras.right.delivering;
  state.flags.verified = constants_.verified;
  state.flags.simulated = constants_.simulated;
  state.flags.clock_synchronised = clock.synchronised();
  state.state = activity(cameras);
  state.started = started_;
  state.heartbeat = heartbeat_;
  if (!constants_.calibrated) state.faults.insert(Fault::kNoCalibration);
  if (camera_state(cameras.left) == registers::CameraState::kMissing) state.faults.insert(Fault::kLeftCameraLost);
  if (camera_state(cameras.right) == registers::CameraState::kMissing) state.faults.insert(Fault::kRightCameraLost);
  state.warnings = constants_.warnings;
  state.newest = newest_;
  state.exposure_since_start = exposure_since_start_;
  state.pose_since_start = pose_since_start_;
  for (const Side side : kBothSides) state.cameras[side] = stats(side, cameras[side]);
  if (latency_.quantile(0.5) > Duration{0}) {
    state.health.latency_p50_us = microseconds(latency_.quantile(0.5));
    state.health.latency_p99_us = microseconds(latency_.quantile(0.99));
  }
  return state;
}

registers::State UnitReport::activity(const PerSide<CameraStatus>& cameras) const {
  if (stopped_) return registers::State::kStopped;
  if (!constants_.calibrated) return registers::State::kNoCalibration;
  for (const Side side : kBothSides) {
    if (camera_state(cameras[side]) == registers::CameraState::kMissing) return registers::State::kCameraFault;
  }
  if (!newest_) return registers::State::kStarting;
  return newest_->measurement.pose ? registers::State::kMeasuring : registers::State::kSearching;
}

CameraStats UnitReport::stats(Side side, const CameraStatus& camera) const {
  CameraStats stats;
  stats.state = camera_state(camera);
  stats.frames_per_second = camera.rate_hz;
  if (camera.info.exposure > Duration{0}) stats.exposure_us = microseconds(camera.info.exposure);
  stats.gain = camera.info.gain;
  stats.dropped = clipped<std::uint32_t>(camera.dropped);
  if (newest_ && camera.delivering) {
    const ImageHealth& health = newest_->measurement.health[side];
    stats.spots = newest_->measurement.spots[side];
    stats.spot_peak = health.peak_luma;
    stats.image_mean = health.mean_luma;
    stats.focus_per_px = health.focus;
    const bool leds = constants_.identity.mode != registers::Mode::kApriltagPose;  // the margin is that of LEDs
    if (const auto margin = leds ? margin_of(newest_->measurement, side) : std::nullopt) {
      stats.above_dim = margin->above_dim;
      stats.below_clipping = margin->below_clipping;
    }
  }
  return stats;
}

}  // namespace tripoint
