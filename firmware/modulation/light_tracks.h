// The lights of one camera, followed from picture to picture, in which they may be out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "line/align/association.h"
#include "line/observation.h"
#include "modulation/light_track.h"
#include "modulation/place_light.h"
#include "ports/frame.h"

namespace tripoint {

/// What was lit all the while that a row of a picture was exposed; nothing when that changed or is not known.
using LitAtRow = std::function<std::optional<LitLeds>(double row_px)>;

/// Middle of the exposure of a row, as stamped.
TimePoint time_of_row(const Observation& seen, double row_px);

class LightTracks {
 public:
  /// Each light may be any LED of this code, or none.
  explicit LightTracks(const LedCode& code) : code_(code) {}

  void clear() { tracks_.clear(); }

  /// Takes one picture after the other, each seen whole: where each light is now, and what its blinking says.
  void follow(const Observation& seen, const Picture& picture, const LitAtRow& lit_at);

  [[nodiscard]] const FixedVector<LightTrack, kMaxImagePoints>& all() const { return tracks_; }
  /// The light that a point of the last picture shows; null where there was no room for it.
  [[nodiscard]] const LightTrack* of_point(std::size_t point) const;
  /// Whether another light is, or should be, so close that both are measured as one.
  [[nodiscard]] bool touched(const LightTrack& track) const;

 private:
  void link(const Observation& seen, const LitAtRow& lit_at);
  void look_for(LightTrack& missed, const Picture& picture, const std::optional<LitLeds>& lit);
  void drop_unsure(const Observation& seen);
  void begin(const Observation& seen, const LitAtRow& lit_at);

  LedCode code_;
  PlaceLight place_light_;
  FixedVector<LightTrack, kMaxImagePoints> tracks_;
  FixedVector<Link, kMaxImagePoints> links_;                                 // of the last picture's points
  FixedVector<std::optional<std::size_t>, kMaxImagePoints> track_of_point_;  // likewise
};

}  // namespace tripoint
