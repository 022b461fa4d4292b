// Notices that both cameras deliver and still no common time comes: their stamps lie too far apart, or stand still.
#pragma once

#include <optional>

#include "line/align/align.h"
#include "line/align/tracks.h"
#include "values/time.h"

namespace tripoint {

class Patience {
 public:
  /// @param camera_silence  after twice as long there is a verdict, so that a camera that falls silent is named first
  void limit_to(Duration camera_silence) { limit_ = 2 * camera_silence; }

  /// What align found. When it has brought no verdict for longer than the limit although no camera is lost, a verdict
  /// without a common time is due, with kTimingBound; again and again while it lasts.
  Aligned judged(Aligned seen, const Tracks& tracks);

 private:
  Duration limit_{200'000'000};
  std::optional<TimePoint> waiting_since_;
};

}  // namespace tripoint
