#include "sim/frame_schedule.h"

#include <algorithm>
#include <cmath>

#include "sim/random_key.h"

namespace tripoint {
namespace {

constexpr double kMaxJitterSigmas = 4.0;

}  // namespace

FrameSchedule::FrameSchedule(const SimulatedWorld& world, Side side)
    : first_(world.start() + world.settings().clocks[side].phase),
      period_ns_(1e9 / world.settings().rate_hz * (1.0 + 1e-6 * world.settings().clocks[side].drift_ppm)),
      readout_(world.settings().exposure / 2 +
               world.settings().line_time * (world.rig().cameras[side].size.height_px - 1)),
      clock_(world.settings().clocks[side]),
      seed_(mixed(world.settings().seed ^ (side == Side::kLeft ? 0x6CU : 0x72U))) {}

TimePoint FrameSchedule::exposed(std::uint64_t frame) const {
  return first_ + Duration{std::llround(period_ns_ * static_cast<double>(frame))};
}

TimePoint FrameSchedule::stamp(std::uint64_t frame) const {
  const double sigmas = std::clamp(normal_from(seed_ + frame), -kMaxJitterSigmas, kMaxJitterSigmas);
  return exposed(frame) + clock_.stamp_latency + duration_from_seconds(sigmas * seconds(clock_.stamp_jitter));
}

TimePoint FrameSchedule::ready(std::uint64_t frame) const { return exposed(frame) + readout_; }

std::uint64_t FrameSchedule::newest_ready(TimePoint now) const {
  const double since_first_ns = static_cast<double>((now - first_ - readout_).count());
  auto frame = static_cast<std::uint64_t>(std::max(std::floor(since_first_ns / period_ns_), 0.0));
  if (frame > 0 && ready(frame) > now) --frame;  // the rounding of whole nanoseconds
  return frame;
}

}  // namespace tripoint
