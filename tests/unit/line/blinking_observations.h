// What two cameras see of LEDs that are switched: pictures in which they are out, and points that carry their ids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "line/line.h"
#include "line/model.h"
#include "synthetic_cameras.h"
#include "values/side.h"

namespace tripoint::testing {

/// All lit, some out, all, all, some out: the second and the last of five are no pictures of the LEDs.
inline bool is_out(std::uint32_t frame) { return frame % 5 == 1 || frame % 5 == 4; }

/// The LEDs carry the ids 11, 12, ...
inline std::vector<Event> blinking(const std::vector<Path>& leds, const Shooting& shooting) {
  std::vector<Event> events = shot(webcam_model(), leds, shooting);
  PerSide<std::uint32_t> left_out{0, 0};
  for (Event& event : events) {
    auto& seen = std::get<Observation>(event);
    for (std::size_t i = 0; i < seen.points.size(); ++i) seen.points[i].led = static_cast<std::uint16_t>(11 + i);
    seen.leds_out = is_out(seen.frame);
    if (seen.leds_out) {
      seen.points.clear();
      ++left_out[seen.side];
    } else {
      seen.left_out = std::exchange(left_out[seen.side], 0U);
    }
  }
  return events;
}

/// A target of LEDs 11, 12, ... in a row.
inline LineModel model_of(std::size_t leds) {
  LineModel model = webcam_model();
  model.target.points.clear();
  for (std::size_t i = 0; i < leds; ++i) {
    model.target.points.push_back({static_cast<int>(11 + i), Vec3(40.0 * static_cast<double>(i), 0.0, 0.0), 0.05});
  }
  return model;
}

}  // namespace tripoint::testing
