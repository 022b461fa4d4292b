#include "modulation/light_tracks.h"

#include <algorithm>

namespace tripoint {
namespace {

constexpr double kFarthest_px = 120.0;  // between two sightings: 1600 px/s over 75 ms
// At 30 pictures a second 67 ms is the longest way between two pictures in which all are lit, and one may be missed.
constexpr Duration kLost = std::chrono::milliseconds(110);
constexpr double kDarkShare = 0.5;    // of the light's own contrast: below it the place is dark
constexpr double kTouchSigmas = 4.0;  // closer than that two spots are measured together
constexpr double kReachSigmas = 1.5;  // of a spot's light, around its middle

Vec2 place_of(const ImagePoint& point) { return {point.at.u_px, point.at.v_px}; }
RawPixel pixel_at(const Vec2& place_px) { return {place_px.x(), place_px.y()}; }

}  // namespace

TimePoint time_of_row(const Observation& seen, double row_px) {
  return seen.exposed + duration_from_seconds(row_px * seconds(seen.line_time));
}

void LightTracks::follow(const Observation& seen, const Picture& picture, const LitAtRow& lit_at) {
  link(seen, lit_at);
  for (LightTrack& track : tracks_) {
    if (!track.seen) look_for(track, picture, lit_at(track.expected_px.y()));
  }
  drop_unsure(seen);
  begin(seen, lit_at);
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    if (!track_of_point_[i]) continue;
    const ImagePoint& point = seen.points[i];
    const double reach_px = std::min(kReachSigmas * point.sigma_px, PlaceLight::kMaxRadius_px);
    tracks_[*track_of_point_[i]].contrast = place_light_.contrast(picture, point.at, reach_px);
  }
}

const LightTrack* LightTracks::of_point(std::size_t point) const {
  const std::optional<std::size_t>& track = track_of_point_[point];
  return track ? &tracks_[*track] : nullptr;
}

bool LightTracks::touched(const LightTrack& track) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const LightTrack& other) {
    if (&other == &track) return false;
    const Vec2& place_px = other.seen ? other.place_px : other.expected_px;
    return (place_px - track.place_px).norm() < kTouchSigmas * std::max(track.sigma_px, other.sigma_px);
  });
}

void LightTracks::link(const Observation& seen, const LitAtRow& lit_at) {
  FixedVector<Vec2, kMaxImagePoints> expected;
  for (LightTrack& track : tracks_) {
    expect_at(track, time_of_row(seen, track.place_px.y()));
    expected.push_back(track.expected_px);
  }
  FixedVector<Vec2, kMaxImagePoints> places;
  for (const ImagePoint& point : seen.points) places.push_back(place_of(point));
  links_ = linked({expected.begin(), expected.size()}, {places.begin(), places.size()}, kFarthest_px);
  track_of_point_.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    track_of_point_.push_back(std::nullopt);
    if (!links_[i].before) continue;
    LightTrack& track = tracks_[*links_[i].before];
    if ((places[i] - track.expected_px).norm() > track.unsure_px) continue;
    see(track, seen.points[i], time_of_row(seen, places[i].y()));
    if (const auto lit = lit_at(places[i].y())) track.blink.take_seen(*lit);
    track_of_point_[i] = links_[i].before;
  }
}

/// Where no spot was found there may be light all the same: only a dark place says that the light is out.
void LightTracks::look_for(LightTrack& missed, const Picture& picture, const std::optional<LitLeds>& lit) {
  if (!lit) return;
  const double reach_px = kReachSigmas * missed.sigma_px + (missed.velocity_px_per_s ? missed.unsure_px : 0.0);
  const std::optional<int> contrast = reach_px <= PlaceLight::kMaxRadius_px
                                          ? place_light_.contrast(picture, pixel_at(missed.expected_px), reach_px)
                                          : std::nullopt;
  if (contrast && missed.contrast && *contrast < kDarkShare * *missed.contrast) {
    missed.blink.take_dark(*lit);
  } else {
    missed.blink.take_unclear(*lit);
  }
}

/// Tracks that were lost, and those that a spot may belong to which more than one explains: no identity survives that.
void LightTracks::drop_unsure(const Observation& seen) {
  const auto is_unsure = [&](const LightTrack& track) {
    if (track.seen) return false;
    if (time_of_row(seen, track.expected_px.y()) - track.at > kLost) return true;
    const double reach_px = track.unsure_px + kTouchSigmas * track.sigma_px;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (links_[i].ambiguous && (place_of(seen.points[i]) - track.expected_px).norm() <= reach_px) return true;
    }
    return false;
  };
  FixedVector<LightTrack, kMaxImagePoints> kept;
  for (std::size_t old = 0; old < tracks_.size(); ++old) {
    if (is_unsure(tracks_[old])) continue;
    auto* const its_point = std::find(track_of_point_.begin(), track_of_point_.end(), old);
    if (its_point != track_of_point_.end()) *its_point = kept.size();
    kept.push_back(tracks_[old]);
  }
  tracks_ = kept;
}

void LightTracks::begin(const Observation& seen, const LitAtRow& lit_at) {
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    if (track_of_point_[i]) continue;
    const ImagePoint& point = seen.points[i];
    LightTrack track = first_seen(point, time_of_row(seen, point.at.v_px), code_);
    if (const auto lit = lit_at(point.at.v_px)) track.blink.take_seen(*lit);
    if (!tracks_.try_push_back(track)) continue;
    track_of_point_[i] = tracks_.size() - 1;
  }
}

}  // namespace tripoint
