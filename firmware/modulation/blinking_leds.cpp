#include "modulation/blinking_leds.h"

#include <algorithm>
#include <utility>

namespace tripoint {
namespace {

constexpr Duration kUnknownExposure = std::chrono::milliseconds(100);

/// On either side of its middle: while a row was exposed, for all that is known.
Duration half_of_exposure(const Observation& seen, Duration stamp_error) {
  return seen.exposure.value_or(kUnknownExposure) / 2 + stamp_error;
}

}  // namespace

BlinkingLeds::BlinkingLeds(const BlinkSettings& settings, const SwitchLog& log, Latest<std::optional<Rhythm>>& rhythm)
    : settings_(settings), code_(settings.leds.size()), log_(log), rhythm_(rhythm), lights_(code_) {}

Observation BlinkingLeds::sifted(const Observation& seen, const Picture& picture) {
  verdicts_.clear();
  if (seen.health.identical) return seen;  // an old picture, which is measured by nobody
  if (last_frame_ && static_cast<std::int32_t>(seen.frame - *last_frame_) <= 0) lights_.clear();
  last_frame_ = seen.frame;
  clock_.take(seen.frame, seen.exposed);
  lights_.follow(seen, picture, [&](double row_px) { return lit_at(seen, row_px); });
  for (std::size_t i = 0; i < seen.points.size(); ++i) verdicts_.push_back(verdict_of(seen, i));
  const Rows rows = rows_of_interest(picture);
  tell_rhythm(seen, rows);

  Observation sifted = with_leds_alone(seen);
  sifted.leds_out = lit_at(seen, rows.first_px) != code_.all() || lit_at(seen, rows.last_px) != code_.all();
  if (sifted.leds_out) {
    sifted.points.clear();
    ++left_out_;
  } else {
    sifted.left_out = std::exchange(left_out_, 0);
  }
  return sifted;
}

/// What had arrived was exposed before, whatever the stamp says.
std::optional<LitLeds> BlinkingLeds::lit_at(const Observation& seen, double row_px) const {
  const Duration half = half_of_exposure(seen, settings_.stamp_error);
  const TimePoint middle = time_of_row(seen, row_px);
  return log_.during(middle - half, std::min(middle + half, seen.arrived));
}

SpotVerdict BlinkingLeds::verdict_of(const Observation& seen, std::size_t point) const {
  const LightTrack* light = lights_.of_point(point);
  if (light == nullptr) return SpotVerdict::kUnproven;
  if (light->blink.none()) return SpotVerdict::kAmbient;
  const std::optional<std::size_t> led = light->blink.led();
  const std::optional<LitLeds> lit = lit_at(seen, light->place_px.y());
  if (!led || !lit || !lit->contains(*led)) return SpotVerdict::kUnproven;
  return lights_.touched(*light) ? SpotVerdict::kAmbient : SpotVerdict::kLed;
}

/// Those of the LEDs; as long as there are none, of everything that may still be one; without any the middle.
BlinkingLeds::Rows BlinkingLeds::rows_of_interest(const Picture& picture) const {
  for (const bool only_leds : {true, false}) {
    std::optional<Rows> rows;
    for (const LightTrack& light : lights_.all()) {
      if (only_leds ? !light.blink.led() : light.blink.none()) continue;
      const double row_px = light.seen ? light.place_px.y() : light.expected_px.y();
      if (!rows) rows = Rows{row_px, row_px};
      rows = Rows{std::min(rows->first_px, row_px), std::max(rows->last_px, row_px)};
    }
    if (rows) return *rows;
  }
  const double middle_px = 0.5 * picture.size.height_px;
  return {middle_px, middle_px};
}

void BlinkingLeds::tell_rhythm(const Observation& seen, const Rows& rows) {
  if (clock_.period() <= Duration{0}) return;
  const double line_s = seconds(seen.line_time);
  const double middle_px = 0.5 * (rows.first_px + rows.last_px);
  const double half_of_rows_px = 0.5 * (rows.last_px - rows.first_px);
  rhythm_.put(
      Rhythm{.middle = clock_.time_of(seen.frame) + duration_from_seconds(middle_px * line_s),
             .period = clock_.period(),
             .half = half_of_exposure(seen, settings_.stamp_error) + duration_from_seconds(half_of_rows_px * line_s)});
}

Observation BlinkingLeds::with_leds_alone(Observation seen) const {
  const FixedVector<ImagePoint, kMaxImagePoints> points = std::exchange(seen.points, {});
  ImageHealth& health = seen.health;
  health.peak_luma = 0.0;
  health.dimmest_luma = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (verdicts_[i] != SpotVerdict::kLed) continue;
    ImagePoint point = points[i];
    point.led = settings_.leds[*lights_.of_point(i)->blink.led()];
    health.dimmest_luma = seen.points.empty() ? point.peak : std::min(health.dimmest_luma, point.peak);
    health.peak_luma = std::max(health.peak_luma, point.peak);
    seen.points.push_back(point);
  }
  return seen;
}

}  // namespace tripoint
