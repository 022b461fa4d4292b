#include "line/align/tracks.h"

#include <algorithm>
#include <variant>

namespace tripoint {
namespace {

constexpr int kMostRepeats = 2;  // one may be chance, in a dark scene, or a camera that fills up its rate

TimePoint time_of(const Event& event) {
  if (const auto* seen = std::get_if<Observation>(&event)) return seen->arrived;
  if (const auto* lost = std::get_if<CameraLost>(&event)) return lost->at;
  if (const auto* back = std::get_if<CameraBack>(&event)) return back->at;
  return std::get<Tick>(event).at;
}

}  // namespace

void Tracks::start_over(Duration camera_silence) {
  camera_silence_ = camera_silence;
  for (const Side side : kBothSides) tracks_[side].clear();
}

void Tracks::take(const Event& event) {
  now_ = std::max(now_, time_of(event));
  fresh_.reset();
  for (const Side side : kBothSides) {
    presence_[side].changed = false;
    if (!begun_) presence_[side].last_sign = now_;
  }
  begun_ = true;
  std::visit([this](const auto& what) { take(what); }, event);
  notice_silence();
}

void Tracks::take(const Observation& seen) {
  Presence& presence = presence_[seen.side];
  presence.last_sign = now_;
  presence.repeats = seen.health.identical ? presence.repeats + 1 : 0;
  if (presence.repeats >= kMostRepeats) lose(seen.side);
  if (seen.health.identical) return;
  welcome(seen.side);
  if (seen.leds_out) return;
  tracks_[seen.side].take(seen);
  fresh_ = seen.side;
}

void Tracks::lose(Side side) {
  presence_[side].changed = !presence_[side].lost;
  presence_[side].lost = true;
  tracks_[side].clear();
}

void Tracks::welcome(Side side) {
  presence_[side].last_sign = now_;
  if (!presence_[side].lost) return;
  presence_[side].changed = true;
  presence_[side].lost = false;
  tracks_[side].clear();
}

void Tracks::notice_silence() {
  for (const Side side : kBothSides) {
    if (!presence_[side].lost && now_ - presence_[side].last_sign > camera_silence_) lose(side);
  }
}

}  // namespace tripoint
