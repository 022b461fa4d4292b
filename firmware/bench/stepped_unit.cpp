#include "bench/stepped_unit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kLateness = 77;  // its own sequence of draws

SimulationSettings switched_by(SimulationSettings settings, const SimulatedLeds& leds) {
  settings.lit_share = [&leds](std::size_t line, Duration from_1970, Duration to_1970) {
    return leds.lit_share(line, TimePoint{from_1970}, TimePoint{to_1970});
  };
  return settings;
}

BlinkSettings blink_settings(const Target& target, const Switching& switching) {
  BlinkSettings settings{.leds = {}, .stamp_error = switching.stamp_error};
  for (const TargetPoint& point : target.points) settings.leds.push_back(static_cast<std::uint16_t>(point.id));
  return settings;
}

}  // namespace

SteppedUnit::SteppedUnit(const SimulationSettings& settings, const LineModel& model,
                         const std::optional<Switching>& switching, UnitWatcher watcher)
    : world_(SimulatedWorld::create(switching ? switched_by(settings, leds_) : settings, clock_.now()).value()),
      line_(std::make_shared<const LineModel>(model)),
      lateness_(settings.seed, kLateness),
      watcher_(std::move(watcher)) {
  for (const Side side : kBothSides) {
    Eye& eye = eyes_[side];
    eye.schedule = std::make_unique<FrameSchedule>(*world_, side);
    eye.camera = SimulatedCamera::open(*world_, side, clock_, [this](TimePoint time) { clock_.move_to(time); }).value();
    eye.next = eye.schedule->newest_ready(clock_.now());
    if (ready(side) <= clock_.now()) ++eye.next;
    if (!switching) continue;
    eye.blinking = std::make_unique<BlinkingLeds>(blink_settings(model.target, *switching), log_, rhythms_[side]);
  }
  if (!switching) return;
  SwitchedLines lines;
  for (std::size_t led = 0; led < model.target.points.size(); ++led) lines.push_back(leds_.line(led));
  const double lateness_s = seconds(switching->lateness);
  switcher_.emplace(
      std::move(lines),
      SwitcherLinks{.log = log_,
                    .rhythms = rhythms_,
                    .clock = clock_,
                    .wait_until =
                        [this, lateness_s](TimePoint time) {
                          look_until(time + duration_from_seconds(std::abs(lateness_.normal()) * lateness_s));
                        },
                    .say = [](std::string_view) {}});
}

void SteppedUnit::run_for(Duration duration) {
  const TimePoint end = clock_.now() + duration;
  if (!switcher_) look_until(end);
  while (clock_.now() < end) switcher_->step();
}

void SteppedUnit::look_until(TimePoint time) {
  while (std::min(ready(Side::kLeft), ready(Side::kRight)) <= time) {
    look(ready(Side::kLeft) <= ready(Side::kRight) ? Side::kLeft : Side::kRight);
  }
  clock_.move_to(time);
}

void SteppedUnit::look(Side side) {
  Eye& eye = eyes_[side];
  const Frame frame = eye.camera->next_frame(std::chrono::seconds{1}).value();
  ++eye.next;
  const Picture picture = picture_of(frame);
  const Detection found = eye.detector.detect(picture, {});
  Observation seen;
  seen.side = side;
  seen.frame = frame.sequence;
  seen.exposed = frame.exposed;
  seen.arrived = frame.arrived;
  seen.line_time = frame.line_time;
  seen.exposure = eye.camera->info().exposure;
  seen.points = found.points;
  seen.health = found.health;
  const Observation believed = eye.blinking ? eye.blinking->sifted(seen, picture) : seen;
  if (watcher_.picture) watcher_.picture(believed, eye.camera->truth(), *world_);
  const std::optional<Measurement> verdict = line_.step(believed);
  if (verdict && watcher_.verdict) watcher_.verdict(*verdict);
}

}  // namespace tripoint::bench
