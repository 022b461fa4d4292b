#include "sim/simulated_camera.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>

namespace tripoint {
namespace {

bool is_planned(const SimulatedWorld& world, Side side, Trouble trouble, TimePoint at) {
  const Duration since_start = at - world.start();
  return std::ranges::any_of(world.settings().troubles, [&](const PlannedTrouble& planned) {
    return planned.side == side && planned.trouble == trouble && since_start >= planned.from &&
           since_start < planned.to;
  });
}

tl::unexpected<Error> unplugged(Side side) {
  return failure(ErrorCode::kDeviceMissing, "simulated camera " + std::string(name(side)) + ": unplugged by plan");
}

}  // namespace

WaitUntil sleeping_by(const Clock& clock) {
  return [&clock](TimePoint until) {
    const Duration left = until - clock.now();
    if (left > Duration::zero()) std::this_thread::sleep_for(left);
  };
}

SimulatedCamera::SimulatedCamera(const SimulatedWorld& world, Side side, const Clock& clock, WaitUntil wait_until)
    : world_(world),
      side_(side),
      clock_(clock),
      wait_until_(std::move(wait_until)),
      schedule_(world, side),
      renderer_(world, side),
      info_{.name = std::string(name(side)) + " (simulated)",
            .port = "simulated-" + std::string(name(side)),
            .serial = std::string(simulated_serial(side)),
            .size = world.rig().cameras[side].size,
            .format = world.settings().format,
            .rate_hz = world.settings().rate_hz,
            .exposure = world.settings().exposure,
            .gain = world.settings().gain,
            .gains = kSimulatedGains,
            .missing_controls = {}} {
  const TimePoint now = clock_.now();
  first_number_ = schedule_.newest_ready(now);
  if (schedule_.ready(first_number_) <= now) ++first_number_;  // what was exposed before the opening is not delivered
  next_number_ = first_number_;
}

Result<std::unique_ptr<SimulatedCamera>> SimulatedCamera::open(const SimulatedWorld& world, Side side,
                                                               const Clock& clock, WaitUntil wait_until) {
  if (is_planned(world, side, Trouble::kVanish, clock.now())) return unplugged(side);
  return std::unique_ptr<SimulatedCamera>(new SimulatedCamera(world, side, clock, std::move(wait_until)));
}

bool SimulatedCamera::has_trouble(Trouble trouble, TimePoint at) const {
  return is_planned(world_, side_, trouble, at);
}

/// The newest frame not yet handed out, or the next one to come.
std::uint64_t SimulatedCamera::next_number(TimePoint now, TimePoint deadline) const {
  std::uint64_t number = std::max(next_number_, schedule_.newest_ready(now));
  while (has_trouble(Trouble::kHang, schedule_.ready(number)) && schedule_.ready(number) <= deadline) ++number;
  return number;
}

Result<Frame> SimulatedCamera::next_frame(Duration limit) {
  const TimePoint now = clock_.now();
  const TimePoint deadline = now + limit;
  const std::uint64_t number = next_number(now, deadline);
  const TimePoint ready = schedule_.ready(number);
  const bool late = ready > deadline;
  lost_ = lost_ || has_trouble(Trouble::kVanish, now) || has_trouble(Trouble::kVanish, std::min(ready, deadline));
  if (lost_) return unplugged(side_);
  const bool foreseen = !world_.settings().lit_share;  // nobody knows before how a line is going to be switched
  if (!late && foreseen) take(number);                 // before waiting, so that rendering costs no latency
  wait_until_(std::min(ready, deadline));
  if (!late && !foreseen) take(number);
  if (late) {
    return failure(ErrorCode::kTimeout, "simulated camera " + std::string(name(side_)) + ": no frame within the limit");
  }
  if (has_trouble(Trouble::kCorrupt, ready) && info_.format != PixelFormat::kMjpeg) {
    return failure(ErrorCode::kCorruptFrame, "simulated camera " + std::string(name(side_)) + ": damaged by plan");
  }
  return frame(number);
}

void SimulatedCamera::take(std::uint64_t number) {
  next_number_ = number + 1;
  const TimePoint exposed = schedule_.exposed(number);
  const bool repeats = rendered_ != nullptr && has_trouble(Trouble::kRepeat, schedule_.ready(number));
  if (!repeats) {
    rendered_ = &renderer_.render(exposed.time_since_epoch() + clock_.utc_offset(), number);
    truth_ = rendered_->truth;
  }
  truth_.exposed = exposed;
  truth_.stamp = schedule_.stamp(number);
}

Frame SimulatedCamera::frame(std::uint64_t number) const {
  std::span<const std::uint8_t> data = rendered_->pixels;
  if (has_trouble(Trouble::kCorrupt, schedule_.ready(number))) data = data.first(data.size() / 2);
  return {.side = side_,
          .format = info_.format,
          .size = info_.size,
          .stride_bytes = rendered_->stride_bytes,
          .data = data,
          .sequence = static_cast<std::uint32_t>(number - first_number_),
          .exposed = truth_.stamp,
          .arrived = clock_.now(),
          .line_time = world_.settings().line_time};
}

}  // namespace tripoint
