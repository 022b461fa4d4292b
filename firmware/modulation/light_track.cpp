#include "modulation/light_track.h"

namespace tripoint {
namespace {

constexpr double kSpotError_px = 2.0;         // of two places together, where mosaic and clipping bend them
constexpr double kBend_px_per_s2 = 6000.0;    // 3.8 m/s^2 at 400 mm and 628 px
constexpr double kFastest_px_per_s = 1600.0;  // 1 m/s there

void place(LightTrack& track, const ImagePoint& point, TimePoint time) {
  track.place_px = {point.at.u_px, point.at.v_px};
  track.at = time;
  track.sigma_px = point.sigma_px;
  track.seen = true;
}

}  // namespace

LightTrack first_seen(const ImagePoint& point, TimePoint time, const LedCode& code) {
  LightTrack track;
  track.blink = Blink(code);
  place(track, point, time);
  return track;
}

void expect_at(LightTrack& track, TimePoint time) {
  const double after_s = seconds(time - track.at);
  const bool moving = track.velocity_px_per_s.has_value();
  track.seen = false;
  track.expected_px = track.place_px + after_s * track.velocity_px_per_s.value_or(Vec2::Zero());
  track.unsure_px = kSpotError_px + (moving ? 0.5 * kBend_px_per_s2 * after_s * after_s : kFastest_px_per_s * after_s);
}

void see(LightTrack& track, const ImagePoint& point, TimePoint time) {
  const Vec2 before_px = track.place_px;
  const double after_s = seconds(time - track.at);
  place(track, point, time);
  if (after_s > 0.0) track.velocity_px_per_s = (track.place_px - before_px) / after_s;
}

}  // namespace tripoint
