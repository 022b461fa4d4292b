// The latched copy: the first valid pose all of whose pictures began to be exposed after a command or a trigger edge.
#pragma once

#include <cstdint>
#include <memory>

#include "serve/unit_state.h"
#include "values/time.h"

namespace tripoint {

inline constexpr Duration kLatchWait{500'000'000};  ///< registers.md: none within 500 ms, and the command failed

/// What was latched: the measurement and what its 16-bit block needs besides.
struct LatchedCopy {
  PublishedMeasurement published;
  UnitFlags flags;
  Faults faults;
  Warnings warnings;
  std::uint16_t heartbeat = 0;
  std::uint16_t setup = 0;
};

enum class LatchOutcome : std::uint8_t { kNone, kWaiting, kFilled, kNoPose };

/// The state of the latch. `copy` is there exactly when the outcome is kFilled.
struct Latch {
  std::uint32_t number = 0;  ///< of the request, +1 for each
  TimePoint requested{};
  LatchOutcome outcome = LatchOutcome::kNone;
  std::shared_ptr<const LatchedCopy> copy;  ///< shared with the answers that are being made from it
};

/// A new request: what was latched before is no longer valid.
Latch requested(const Latch& latch, TimePoint at);

/// Time passes: a request that waited longer than kLatchWait has failed.
Latch expired(const Latch& latch, TimePoint now);

/// The unit publishes: a waiting latch takes the pose when all of its pictures began to be exposed after the request,
/// by more than twice the standard deviation of the offset between the cameras' stamps. A latency that both cameras
/// have in common is not in that number.
Latch filled(const Latch& latch, const UnitState& state);

}  // namespace tripoint
