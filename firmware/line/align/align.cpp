#include "line/align/align.h"

#include <algorithm>
#include <optional>

#include "line/align/at_time.h"

namespace tripoint {
namespace {

constexpr Duration kSameTime{
    1'000'000};  // common times closer than 1 ms are one: no second verdict on the same pictures

/// When a picture's first point was exposed.
TimePoint exposed(const StampClock& clock, const TrackedPicture& picture) {
  return time_of_row(clock, picture, picture.first_row_px);
}

/// Both tracks must reach back to a common time.
bool reaches_back_to(TimePoint time, const Tracks& tracks, const Clocks& clocks) {
  return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
    const Track& track = tracks[side];
    return exposed(clocks[side], track.picture(track.size() - 1)) <= time;
  });
}

/// The earlier of both cameras' newest pictures, `skip` pictures back in each.
std::optional<TimePoint> common_time(const Tracks& tracks, const Clocks& clocks, const PerSide<std::size_t>& skip) {
  std::optional<TimePoint> earliest;
  for (const Side side : kBothSides) {
    if (tracks[side].size() <= skip[side]) return std::nullopt;
    const TimePoint newest = exposed(clocks[side], tracks[side].picture(skip[side]));
    earliest = earliest ? std::min(*earliest, newest) : newest;
  }
  return earliest;
}

/// Nothing unless the picture that just came moved the common time on.
std::optional<TimePoint> new_common_time(const Tracks& tracks, const Clocks& clocks) {
  if (!tracks.fresh() || tracks.lost(Side::kLeft) || tracks.lost(Side::kRight)) return std::nullopt;
  const std::optional<TimePoint> now = common_time(tracks, clocks, {0, 0});
  PerSide<std::size_t> skip{0, 0};
  skip[*tracks.fresh()] = 1;
  const std::optional<TimePoint> before = common_time(tracks, clocks, skip);
  if (!now || !reaches_back_to(*now, tracks, clocks)) return std::nullopt;
  if (before && *now - *before < kSameTime) return std::nullopt;
  return now;
}

Aligned camera_change(const Tracks& tracks) {
  Aligned seen;
  seen.at = tracks.now();
  seen.exposure_began = seen.at;
  if (tracks.lost(Side::kLeft)) seen.faults.insert(Fault::kLeftCameraLost);
  if (tracks.lost(Side::kRight)) seen.faults.insert(Fault::kRightCameraLost);
  const auto came_back = [&](Side side) { return tracks.changed(side) && !tracks.lost(side); };
  if (came_back(Side::kLeft)) seen.faults.insert(Fault::kNotSeenLeft);
  if (came_back(Side::kRight)) seen.faults.insert(Fault::kNotSeenRight);
  seen.due = tracks.changed(Side::kLeft) || tracks.changed(Side::kRight);
  return seen;
}

/// Numbers that are none, spots that were not looked at, and places where nobody looked for others.
Faults faults_of(const TrackedPicture& picture) {
  Faults faults;
  if (picture.broken) faults.insert(Fault::kInternal);
  if (picture.health.candidates_cut || picture.unwatched) faults.insert(Fault::kAmbiguous);
  return faults;
}

}  // namespace

Aligned align(const Tracks& tracks, const Clocks& clocks) {
  Aligned seen = camera_change(tracks);
  const std::optional<TimePoint> time = new_common_time(tracks, clocks);
  if (seen.due || !time) return seen;

  seen.due = true;
  seen.common_time = true;
  seen.at = *time;
  seen.exposure_began = *time;
  const PerSide<TimePoint> newest{exposed(clocks[Side::kLeft], tracks[Side::kLeft].picture(0)),
                                  exposed(clocks[Side::kRight], tracks[Side::kRight].picture(0))};
  seen.skew_s = seconds(newest.right - newest.left);
  seen.offset_sigma_s = clocks.offset_sigma_s();
  seen.timed = newest.left <= newest.right ? Side::kRight : Side::kLeft;
  for (const Side side : kBothSides) {
    const double offset_sigma_s = side == seen.timed ? seen.offset_sigma_s : 0.0;
    const PointsAtTime found = points_at_time(tracks[side], clocks[side], *time, offset_sigma_s);
    seen.points[side] = found.points;
    seen.exposure_began = std::min(seen.exposure_began, found.exposure_began);
    seen.faults.insert(found.faults);
    seen.spots[side] = static_cast<std::uint16_t>(found.spots);
    seen.health[side] = found.picture->health;
    seen.faults.insert(faults_of(*found.picture));
    seen.faults.insert(faults_of(tracks[side].picture(0)));
    if (tracks[side].picture(0).frames_dropped) seen.warnings.insert(Warning::kFramesDropped);
  }
  return seen;
}

}  // namespace tripoint
