#include "serve/latch.h"

namespace tripoint {

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
  if (!measurement.pose || !faults.empty() || measurement.exposure_began <= latch.requested) return latch;
  Warnings warnings = measurement.warnings;
  warnings.insert(state.warnings);
  return Latch{latch.number, latch.requested, LatchOutcome::kFilled,
               std::make_shared<const LatchedCopy>(
                   LatchedCopy{*state.newest, state.flags, faults, warnings, state.heartbeat, state.identity.setup})};
}

}  // namespace tripoint
