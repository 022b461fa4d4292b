// One measurement as it is shown at the moment of an answer: what is valid, how old it is, and why not.
#pragma once

#include <cstdint>
#include <optional>

#include "serve/latch.h"
#include "serve/pose_numbers.h"
#include "serve/unit_state.h"
#include "values/time.h"

namespace tripoint {

/// The content of a pose block, whatever its number format. `pose` is there exactly when status bit 2 is set,
/// `pose->orientation` exactly when bit 3 is.
struct Reading {
  std::uint32_t sequence = 0;
  std::uint16_t status = 0;
  std::uint16_t faults = 0;
  std::uint16_t warnings = 0;
  std::uint64_t time_ns = 0;  ///< since 1970 UTC
  std::optional<double> age_ms;
  std::optional<PoseNumbers> pose;
  std::optional<double> residual_px;
  std::uint16_t points_used = 0;
  std::uint16_t setup = 0;
  std::uint16_t heartbeat = 0;

  [[nodiscard]] bool has(registers::StatusBit bit) const { return (status >> static_cast<unsigned>(bit) & 1U) != 0; }
};

/// The newest measurement: stale and not valid past the age limit or once the unit has stopped, whatever it says
/// itself.
Reading live_reading(const UnitState& state, const Latch& latch, TimePoint now);

/// The latched copy: not valid past the hold limit, after a change of setup, and while nothing is latched.
Reading latched_reading(const UnitState& state, const Latch& latch, TimePoint now);

/// The same without a pose: for a block whose feature does not exist, or whose numbers do not fit.
Reading without_pose(Reading reading);

}  // namespace tripoint
