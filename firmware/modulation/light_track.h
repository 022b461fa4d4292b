// One light as it moves through the pictures of a camera.
#pragma once

#include <optional>

#include "line/observation.h"
#include "modulation/blink.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

struct LightTrack {
  Vec2 place_px = Vec2::Zero();  ///< where it was seen last
  TimePoint at{};                ///< when
  std::optional<Vec2> velocity_px_per_s;
  double sigma_px = 0.0;
  std::optional<int> contrast;      ///< S of the spot above its surroundings; absent at the border
  Vec2 expected_px = Vec2::Zero();  ///< in the picture at hand
  double unsure_px = 0.0;           ///< how far from there it may be
  bool seen = false;                ///< in the picture at hand
  Blink blink;
};

/// A light that was not there before.
LightTrack first_seen(const ImagePoint& point, TimePoint time, const LedCode& code);

/// Sets where the light has to be at a time.
void expect_at(LightTrack& track, TimePoint time);

/// Sets where it is.
void see(LightTrack& track, const ImagePoint& point, TimePoint time);

}  // namespace tripoint
