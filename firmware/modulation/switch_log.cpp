#include "modulation/switch_log.h"

namespace tripoint {

void SwitchLog::begin(TimePoint at) {
  const std::scoped_lock lock(mutex_);
  Steady& newest = ring_[(next_ + kKept - 1) % kKept];
  if (begun_ && !newest.to) newest.to = at;
  begun_ = true;
}

void SwitchLog::complete(TimePoint at, std::optional<LitLeds> lit) {
  const std::scoped_lock lock(mutex_);
  ring_[next_] = {.from = at, .to = std::nullopt, .lit = lit};
  next_ = (next_ + 1) % kKept;
}

std::optional<LitLeds> SwitchLog::during(TimePoint from, TimePoint to) const {
  const std::scoped_lock lock(mutex_);
  for (const Steady& steady : ring_) {
    if (steady.lit && steady.from <= from && (!steady.to || to <= *steady.to)) return steady.lit;
  }
  return std::nullopt;
}

}  // namespace tripoint
