#include "modulation/switching_moment.h"

#include <algorithm>
#include <chrono>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr int kWander = 10;  // parts of a period

/// A time without exposures that repeats with the period.
struct Pause {
  TimePoint middle{};
  Duration half{0};
};

Duration remainder(Duration time, Duration period) {
  const Duration rest = time % period;
  return rest < Duration{0} ? rest + period : rest;
}

/// Between one camera's exposure and the other's, `apart` later; a long exposure of either may reach into it from the
/// period before or after.
Pause between(const Rhythm& first, const Rhythm& second, Duration apart, Duration period) {
  const Duration begin = std::max(first.half, apart - period + second.half);
  const Duration end = std::min(apart - second.half, period - first.half);
  return {first.middle + (begin + end) / 2, (end - begin) / 2};
}

/// The one closest to `usual`.
TimePoint repeated_near(TimePoint moment, TimePoint usual, Duration period) {
  return usual - period / 2 + remainder(moment - usual + period / 2, period);
}

Pause alone(const Rhythm& rhythm) { return {rhythm.middle + rhythm.period / 2, rhythm.period / 2 - rhythm.half}; }

SwitchingMoment moment_in(const Pause& pause, TimePoint usual, Duration period) {
  return {repeated_near(pause.middle, usual, period), pause.half};
}

SwitchingMoment better(const SwitchingMoment& a, const SwitchingMoment& b, TimePoint usual) {
  const bool a_is_usual = std::chrono::abs(a.at - usual) <= std::chrono::abs(b.at - usual);
  const SwitchingMoment& kept = a_is_usual ? a : b;
  const SwitchingMoment& other = a_is_usual ? b : a;
  return 2 * kept.clearance >= other.clearance && kept.clearance > Duration{0} ? kept : other;
}

}  // namespace

SwitchingMoment switching_moment(TimePoint previous, const PerSide<std::optional<Rhythm>>& rhythms) {
  TRIPOINT_ASSERT(rhythms.left || rhythms.right);
  const Rhythm& left = rhythms.left ? *rhythms.left : *rhythms.right;
  const Rhythm& right = rhythms.right ? *rhythms.right : left;
  const Duration period = (left.period + right.period) / 2;
  const TimePoint usual = previous + period;
  const bool both = rhythms.left && rhythms.right;
  const Duration apart = remainder(right.middle - left.middle, period);
  const SwitchingMoment moment =
      both ? better(moment_in(between(left, right, apart, period), usual, period),
                    moment_in(between(right, left, period - apart, period), usual, period), usual)
           : moment_in(alone(left), usual, period);
  if (moment.clearance > Duration{0}) return moment;
  return {usual + period / kWander, moment.clearance};
}

}  // namespace tripoint
