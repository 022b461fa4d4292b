#include "serve/reading.h"

#include <algorithm>

namespace tripoint {
namespace {

using registers::StatusBit;

constexpr Duration kMostAhead{50'000'000};  // an exposure further in the future is a clock gone wrong, not a fresh pose

constexpr std::uint16_t mask(StatusBit bit, bool set = true) {
  return static_cast<std::uint16_t>(set ? 1U << static_cast<unsigned>(bit) : 0U);
}

std::uint16_t unit_bits(const UnitFlags& flags) {
  return static_cast<std::uint16_t>(
      mask(StatusBit::kReady, flags.ready) | mask(StatusBit::kCalibrated, flags.calibrated) |
      mask(StatusBit::kRegistered, flags.registered) | mask(StatusBit::kClockSynchronised, flags.clock_synchronised) |
      mask(StatusBit::kSimulated, flags.simulated) | mask(StatusBit::kVerified, flags.verified));
}

bool identified(const Measurement& measurement) {
  return measurement.pose || std::any_of(measurement.points.begin(), measurement.points.end(),
                                         [](const MeasuredPoint& point) { return point.id != 0; });
}

/// What does not depend on the moment of the answer.
Reading told_by(const PublishedMeasurement& published) {
  const Measurement& measurement = published.measurement;
  Reading reading;
  reading.sequence = static_cast<std::uint32_t>(measurement.sequence);
  reading.time_ns = static_cast<std::uint64_t>(
      std::max<std::int64_t>(0, ns_from_time(measurement.exposed) + published.utc_offset.count()));
  if (!measurement.points.empty()) reading.residual_px = measurement.residual_rms_px;
  reading.points_used = static_cast<std::uint16_t>(measurement.points.size());
  return reading;
}

/// Age in ms; a time of exposure ahead of the clock is age 0.
double age_of(const Measurement& measurement, TimePoint now) {
  return 1e3 * seconds(std::max(Duration{0}, now - measurement.exposed));
}

/// Whether the unit goes on, and its newest verdict is no older than a pose may be. That does not ask for a target.
bool goes_on(const UnitState& state, TimePoint now) {
  const Duration age = now - state.newest->measurement.exposed;
  return state.state != registers::State::kStopped && age <= state.limits.age_limit && age >= -kMostAhead;
}

/// The status bits that speak of the pose. `fresh`: within its age or hold limit.
std::uint16_t pose_bits(const Reading& reading, const Measurement& measurement, bool fresh) {
  const bool oriented = reading.pose && reading.pose->orientation;
  return static_cast<std::uint16_t>(mask(StatusBit::kTracking, fresh && identified(measurement)) |
                                    mask(StatusBit::kPositionValid, reading.pose.has_value()) |
                                    mask(StatusBit::kOrientationValid, oriented) | mask(StatusBit::kStale, !fresh) |
                                    mask(StatusBit::kDegraded, reading.warnings != 0) |
                                    mask(StatusBit::kSettled, fresh && measurement.timing.settled) |
                                    mask(StatusBit::kGimbalLock, oriented && reading.pose->orientation->gimbal_lock));
}

std::optional<PoseNumbers> pose_if(bool shown, const Measurement& measurement) {
  if (!shown || !measurement.pose) return std::nullopt;
  return numbers_of(*measurement.pose);
}

/// The copy that may be shown now, or null.
const LatchedCopy* valid_copy(const UnitState& state, const Latch& latch, TimePoint now) {
  if (latch.outcome != LatchOutcome::kFilled || latch.copy == nullptr) return nullptr;
  // A knock takes time to be noticed: the copy may have been measured after it.
  if (state.newest && state.newest->measurement.faults.contains(Fault::kDecalibration)) return nullptr;
  const bool held = now - latch.copy->published.measurement.exposed <= state.limits.latch_hold;
  return held && latch.copy->setup == state.identity.setup ? latch.copy.get() : nullptr;
}

/// Before the first verdict: no time, no age, and what the unit itself has to say.
Reading nothing_yet(const UnitState& state) {
  Reading reading;
  reading.faults = state.faults.bits();
  reading.warnings = state.warnings.bits();
  reading.setup = state.identity.setup;
  reading.heartbeat = state.heartbeat;
  reading.status = static_cast<std::uint16_t>(unit_bits(state.flags) | mask(StatusBit::kStale) |
                                              mask(StatusBit::kDegraded, !state.warnings.empty()));
  return reading;
}

}  // namespace

Reading live_reading(const UnitState& state, const Latch& latch, TimePoint now) {
  if (!state.newest) return nothing_yet(state);
  const Measurement& measurement = state.newest->measurement;
  Warnings warnings = state.warnings;
  warnings.insert(measurement.warnings);
  Faults faults = state.faults;
  faults.insert(measurement.faults);

  Reading reading = told_by(*state.newest);
  if (!state.exposure_since_start) reading.time_ns = 0;  // the time is that of a camera's loss
  if (state.pose_since_start) reading.age_ms = age_of(measurement, now);
  const bool current = goes_on(state, now);
  const bool fresh = current && reading.age_ms;
  reading.faults = faults.bits();
  reading.warnings = warnings.bits();
  reading.setup = state.identity.setup;
  reading.heartbeat = state.heartbeat;
  reading.pose = pose_if(fresh && faults.empty(), measurement);
  reading.status = static_cast<std::uint16_t>(unit_bits(state.flags) | pose_bits(reading, measurement, fresh) |
                                              mask(StatusBit::kMountWatched, current && measurement.mount_watched) |
                                              mask(StatusBit::kLatched, valid_copy(state, latch, now) != nullptr));
  return reading;
}

Reading latched_reading(const UnitState& state, const Latch& latch, TimePoint now) {
  if (latch.outcome != LatchOutcome::kFilled || latch.copy == nullptr) {
    Reading nothing;
    nothing.status = static_cast<std::uint16_t>(unit_bits(state.flags) | mask(StatusBit::kStale));
    nothing.setup = state.identity.setup;
    return nothing;
  }
  const LatchedCopy& copy = *latch.copy;
  const Measurement& measurement = copy.published.measurement;
  const bool valid = valid_copy(state, latch, now) != nullptr;
  Reading reading = told_by(copy.published);
  reading.age_ms = age_of(measurement, now);
  const bool held = now - measurement.exposed <= state.limits.latch_hold;
  reading.faults = copy.faults.bits();
  reading.warnings = copy.warnings.bits();
  reading.setup = copy.setup;
  reading.heartbeat = copy.heartbeat;
  reading.pose = pose_if(valid, measurement);
  reading.status = static_cast<std::uint16_t>(unit_bits(copy.flags) | pose_bits(reading, measurement, held) |
                                              mask(StatusBit::kMountWatched, held && measurement.mount_watched) |
                                              mask(StatusBit::kLatched, valid));
  return reading;
}

Reading without_pose(Reading reading) {
  constexpr auto kKept = static_cast<std::uint16_t>(
      ~(mask(StatusBit::kPositionValid) | mask(StatusBit::kOrientationValid) | mask(StatusBit::kGimbalLock)));
  reading.pose.reset();
  reading.status = static_cast<std::uint16_t>(reading.status & kKept);
  return reading;
}

}  // namespace tripoint
