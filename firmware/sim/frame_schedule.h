// When a free-running camera exposes its frames, and when it says it did.
#pragma once

#include <cstdint>

#include "sim/world.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// Frames are numbered from 0, on the camera's own clock. Nothing here has a state.
class FrameSchedule {
 public:
  FrameSchedule(const SimulatedWorld& world, Side side);

  /// The true middle of the exposure of row 0.
  [[nodiscard]] TimePoint exposed(std::uint64_t frame) const;
  /// What the driver says: late by the latency, and jittering.
  [[nodiscard]] TimePoint stamp(std::uint64_t frame) const;
  /// When the last row has been exposed and read out.
  [[nodiscard]] TimePoint ready(std::uint64_t frame) const;
  /// The newest frame that is ready at this time; 0 when none is.
  [[nodiscard]] std::uint64_t newest_ready(TimePoint now) const;

 private:
  TimePoint first_;
  double period_ns_;
  Duration readout_;
  CameraClock clock_;
  std::uint64_t seed_;
};

}  // namespace tripoint
