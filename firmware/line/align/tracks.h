// Both cameras' newest pictures, and which camera is there at all.
#pragma once

#include <optional>

#include "line/align/track.h"
#include "line/observation.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

class Tracks {
 public:
  /// Forgets every picture; which camera is lost stays known.
  void start_over(Duration camera_silence);

  /// A camera is lost when it says so, is silent for too long, or repeats itself twice in a row; with its next new
  /// picture, or when its thread says so, it is back. A repeated picture is old whatever its stamp says: it is left
  /// out. So is one in which not all LEDs were lit, which is a sign of life all the same.
  void take(const Event& event);

  const Track& operator[](Side side) const { return tracks_[side]; }
  [[nodiscard]] bool lost(Side side) const { return presence_[side].lost; }
  /// The last event lost this camera or brought it back.
  [[nodiscard]] bool changed(Side side) const { return presence_[side].changed; }
  /// The camera whose picture the last event brought.
  [[nodiscard]] std::optional<Side> fresh() const { return fresh_; }
  /// The time that has passed by the events alone.
  [[nodiscard]] TimePoint now() const { return now_; }

 private:
  struct Presence {
    bool lost = false;
    bool changed = false;
    int repeats = 0;        // in a row
    TimePoint last_sign{};  // of life
  };
  void take(const Observation& seen);
  void take(const CameraLost& event) { lose(event.side); }
  void take(const CameraBack& event) { welcome(event.side); }
  void take(const Tick&) {}
  void lose(Side side);
  void welcome(Side side);
  void notice_silence();

  PerSide<Track> tracks_;
  PerSide<Presence> presence_;
  Duration camera_silence_{100'000'000};
  std::optional<Side> fresh_;
  bool begun_ = false;
  TimePoint now_{};
};

}  // namespace tripoint
