#include "serve/latch.h"

namespace tripoint {
namespace {

constexpr double kCoverage = 2.0;  // standard deviations: 95 %, as every uncertainty in the registers

/// With the stamps' uncertainty to spare; never when that is not a finite number.
bool began_after(const Measurement& measurement, TimePoint request) {
  return seconds(measurement.exposure_began - request) > kCoverage * measurement.timing.skew_sigma_s;
}

}  // namespace

Latch requested(const Latch& latch, TimePoint at) {
  return Latch{latch.number + 1, at, LatchOutcome::kWaiting, nullptr};
}

Latch expired(const Latch& latch, TimePoint now) {
  if (latch.outcome != LatchOutcome::kWaiting || now - latch.requested <= kLatchWait) return latch;
  return Latch{latch.number, latch.requested, LatchOutcome::kNoPose, nullptr};
}

Latch filled(const Latch& latch, const UnitState& state) {
  if (latch.outcome != LatchOutcome::kWaiting || !state.newest) return latch;
  const Measurement& measurement = state.newest->measurement;
  Faults faults = measurement.faults;
  faults.insert(state.faults);
  if (!measurement.pose || !faults.empty() || !began_after(measurement, latch.requested)) return latch;
  Warnings warnings = measurement.warnings;
  warnings.insert(state.warnings);
  return Latch{latch.number, latch.requested, LatchOutcome::kFilled,
               std::make_shared<const LatchedCopy>(
                   LatchedCopy{*state.newest, state.flags, faults, warnings, state.heartbeat, state.identity.setup})};
}

}  // namespace tripoint
