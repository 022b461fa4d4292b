#include "modulation/led_switcher.h"

#include <algorithm>
#include <string>
#include <utility>

namespace tripoint {
namespace {

constexpr Duration kRecent = std::chrono::seconds(1);  // a camera that is silent for longer has no rhythm
constexpr Duration kWaitForCamera = std::chrono::milliseconds(50);

}  // namespace

LedSwitcher::LedSwitcher(SwitchedLines lines, SwitcherLinks links)
    : lines_(std::move(lines)), links_(std::move(links)), code_(lines_.size()) {}

void LedSwitcher::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) step();
  show(LitLeds{});
}

void LedSwitcher::step() {
  const TimePoint now = links_.clock.now();
  const PerSide<std::optional<Rhythm>> rhythms = recent_rhythms(now);
  if (!rhythms.left && !rhythms.right) {
    show(code_.all());
    previous_ = now;
    links_.wait_until(now + kWaitForCamera);
    return;
  }
  previous_ = std::max(previous_, now - (rhythms.left ? rhythms.left : rhythms.right)->period);  // after a stall
  const SwitchingMoment moment = switching_moment(previous_, rhythms);
  previous_ = moment.at;
  if (moment.at < now) return;  // late: that one is left out
  links_.wait_until(moment.at);
  show(code_.lit_in(step_++));
  judge(moment.clearance);
}

PerSide<std::optional<Rhythm>> LedSwitcher::recent_rhythms(TimePoint now) const {
  PerSide<std::optional<Rhythm>> recent;
  for (const Side side : kBothSides) {
    const std::optional<Rhythm> rhythm = links_.rhythms[side].get();
    if (rhythm && now - rhythm->middle < kRecent) recent[side] = rhythm;
  }
  return recent;
}

void LedSwitcher::show(LitLeds wanted) {
  if (shown_ == wanted) return;
  links_.log.begin(links_.clock.now());
  shown_ = wanted;
  std::string trouble;
  for (std::size_t led = 0; led < lines_.size(); ++led) {
    const Result<void> done = lines_[led]->set(wanted.contains(led));
    if (done) continue;
    shown_.reset();
    trouble = "modulation: line of LED " + std::to_string(led + 1) + ": " + done.error().message;
  }
  links_.log.complete(links_.clock.now(), shown_);
  const bool failed = !trouble.empty();
  if (failed != std::exchange(failing_, failed)) {
    links_.say(failed ? std::string_view(trouble) : "modulation: all lines can be switched again");
  }
}

void LedSwitcher::judge(Duration clearance) {
  const bool crowded = clearance <= Duration{0};
  if (crowded == std::exchange(crowded_, crowded)) return;
  links_.say(crowded
                 ? "modulation: one camera or the other is always exposing the rows of the LEDs, so that pictures are "
                   "lost; a shorter exposure helps"
                 : "modulation: the LEDs are switched between the exposures again");
}

}  // namespace tripoint
