#include "sim/simulated_leds.h"

#include <algorithm>

#include "values/assert.h"

namespace tripoint {

class SimulatedLeds::Line final : public SwitchedLine {
 public:
  Line(SimulatedLeds& leds, std::size_t led) : leds_(leds), led_(led) {}
  Result<void> set(bool lit) override {
    leds_.set(led_, lit);
    return {};
  }

 private:
  SimulatedLeds& leds_;
  std::size_t led_;
};

std::unique_ptr<SwitchedLine> SimulatedLeds::line(std::size_t led) {
  TRIPOINT_ASSERT(led < kMaxTargetPoints);
  return std::make_unique<Line>(*this, led);
}

void SimulatedLeds::set(std::size_t led, bool lit) {
  const std::scoped_lock lock(mutex_);
  History& history = histories_[led];
  history.ring[history.next] = {clock_.now(), lit};
  history.next = (history.next + 1) % kKept;
}

double SimulatedLeds::lit_share(std::size_t led, TimePoint from, TimePoint to) const {
  const std::scoped_lock lock(mutex_);
  const History& history = histories_[led];
  Duration lit{0};
  TimePoint until = TimePoint::max();
  for (std::size_t back = 1; back <= kKept && until > from; ++back) {
    const Switching& switching = history.ring[(history.next + kKept - back) % kKept];
    if (switching.at == TimePoint::max()) break;
    const bool at_the_moment = from == to && switching.at <= from && from < until;
    if (at_the_moment) return switching.lit ? 1.0 : 0.0;
    if (switching.lit) lit += std::max(Duration{0}, std::min(until, to) - std::max(switching.at, from));
    until = switching.at;
  }
  return from < to ? seconds(lit) / seconds(to - from) : 0.0;
}

}  // namespace tripoint
