// Varied stereo scenes from a seed: a target with LEDs among everything that is like an LED, and is none.
#pragma once

#include <cstdint>

#include "sim/draws.h"
#include "sim/settings.h"

namespace tripoint {

struct ClutterChoice {
  ImageSize size{.width_px = 640, .height_px = 480};
  int min_leds = 3;  ///< of the target, 1 to 4
  int max_leds = 4;
  Range white_level{0.05, 0.05};      ///< of a white surface, in units of clip; drawn evenly in its logarithm
  Range led_peak{1.0, 3.0};           ///< of every LED in either picture, times clip; drawn evenly in its logarithm
  double red_lamp_probability = 0.0;  ///< that there are one or two lamps of the LEDs' size and colour
};

/// The target stands 350 to 800 mm away: 1 to 4 LEDs, ids 1 to 4 and lines 0 to 3, at the corners of a triangle of 100,
/// 80 and 60 mm and 40 mm before its plane. Around it skin, orange and red things, cables, metal, highlights of which
/// some move, lamps, hot pixels; sometimes a hand in front, a plate behind the LEDs, a mirror, glare. Format and tone
/// are the caller's to change. The same seed and choice give the same scene on every machine.
SimulationSettings clutter_settings(std::uint64_t seed, const ClutterChoice& choice);

}  // namespace tripoint
