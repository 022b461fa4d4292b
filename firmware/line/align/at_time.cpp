#include "line/align/at_time.h"

#include <algorithm>
#include <optional>

namespace tripoint {
namespace {

constexpr Duration kExact{1'000};                  // 1 us: at 1600 px/s a thousandth of a pixel
constexpr Duration kLongestGap{80'000'000};        // two frame periods at 30 fps, one dropped frame
constexpr Duration kLongestExposure{100'000'000};  // of a camera whose frame period is not known either: 10 fps
constexpr double kUsualSpeed_px_per_s = 500.0;     // standard deviation of an unknown speed: 0.3 m/s at 400 mm

constexpr double kBendTurns = 0.5;     // part of a bend that the next frame period may turn sideways
constexpr double kCornerTurns = 0.25;  // part of a corner that may lie sideways of where noise lets it seem to be

/// A time, and the standard deviation with which it is known in this camera.
struct Moment {
  TimePoint time{};
  double offset_sigma_s = 0.0;
};

/// A point in one of the pictures, and the same one further back.
struct Sample {
  std::size_t back = 0;
  std::size_t index = 0;
  TimePoint at{};
  Vec2 place_px = Vec2::Zero();
};

Sample sample_of(const Track& track, const StampClock& clock, std::size_t back, std::size_t index) {
  const TrackedPicture& picture = track.picture(back);
  const RawPixel& at = picture.points[index].at;
  return {back, index, time_of_row(clock, picture, at.v_px), {at.u_px, at.v_px}};
}

std::optional<Sample> sample_before(const Track& track, const StampClock& clock, const Sample& sample) {
  const Link& link = track.picture(sample.back).links[sample.index];
  if (!link.before || sample.back + 1 >= track.size()) return std::nullopt;
  return sample_of(track, clock, sample.back + 1, *link.before);
}

Matrix2 timing_of(const std::optional<Vec2>& velocity_px_per_s, double offset_sigma_s) {
  const double variance_s2 = offset_sigma_s * offset_sigma_s;
  if (velocity_px_per_s) return variance_s2 * *velocity_px_per_s * velocity_px_per_s->transpose();
  return variance_s2 * kUsualSpeed_px_per_s * kUsualSpeed_px_per_s * Matrix2::Identity();
}

/// Acceleration over three pictures; nothing when they do not follow each other in time.
std::optional<Vec2> acceleration_px_per_s2(const Sample& first, const Sample& second, const Sample& third) {
  const double before_s = seconds(second.at - first.at);
  const double after_s = seconds(third.at - second.at);
  if (before_s <= 0.0 || after_s <= 0.0) return std::nullopt;
  const Vec2 change = (third.place_px - second.place_px) / after_s - (second.place_px - first.place_px) / before_s;
  return 2.0 / (before_s + after_s) * change;
}

/// Something left out that is known no better than this. Were it taken to lie exactly in its estimated direction, a
/// small part of it across the epipolar line would seem to reveal all of it.
Matrix2 spread_of(const Vec2& left_out_px, double turns) {
  return left_out_px * left_out_px.transpose() + turns * turns * left_out_px.squaredNorm() * Matrix2::Identity();
}

/// What a straight line leaves out at a share of the way from early to late. A steady acceleration leaves out half of
/// share (1 - share) of its bend, which may turn until the next picture. What has changed in the acceleration may be a
/// corner between the two pictures, which leaves out up to share of that change: taken as two standard deviations.
Matrix2 bend_px2(const Track& track, const StampClock& clock, const Sample& early, const Sample& late, double share) {
  const std::optional<Sample> first = sample_before(track, clock, early);
  const std::optional<Vec2> now = first ? acceleration_px_per_s2(*first, early, late) : std::nullopt;
  if (!now) return Matrix2::Zero();
  const std::optional<Sample> earlier = sample_before(track, clock, *first);
  const Vec2 before = earlier ? acceleration_px_per_s2(*earlier, *first, early).value_or(Vec2::Zero()) : Vec2::Zero();
  const double step_s = seconds(late.at - early.at);
  const double turn_s = 0.5 * (step_s + seconds(early.at - first->at));  // acceleration times it: change of velocity
  const Vec2 steady = 0.5 * share * (1.0 - share) * step_s * step_s * *now;
  const Vec2 corner = 0.5 * share * step_s * turn_s * (*now - before);
  return spread_of(steady, kBendTurns) + spread_of(corner, kCornerTurns);
}

AlignedPoint exact(const Track& track, const StampClock& clock, const Sample& sample, double offset_sigma_s) {
  AlignedPoint point{track.picture(sample.back).points[sample.index], std::nullopt, Matrix2::Zero()};
  const std::optional<Sample> before = sample_before(track, clock, sample);
  if (before && before->at < sample.at && sample.at - before->at <= kLongestGap) {
    point.velocity_px_per_s = (sample.place_px - before->place_px) / seconds(sample.at - before->at);
  }
  point.timing_px2 = timing_of(point.velocity_px_per_s, offset_sigma_s);
  return point;
}

AlignedPoint between(const Track& track, const StampClock& clock, const Sample& early, const Sample& late,
                     const Moment& moment) {
  const double share = seconds(moment.time - early.at) / seconds(late.at - early.at);
  const ImagePoint& before = track.picture(early.back).points[early.index];
  AlignedPoint point{track.picture(late.back).points[late.index], std::nullopt, Matrix2::Zero()};
  const Vec2 place = (1.0 - share) * early.place_px + share * late.place_px;
  point.seen.at = {place.x(), place.y()};
  point.averaging = (1.0 - share) * (1.0 - share) + share * share;
  point.seen.covariance_px2 =
      (1.0 - share) * (1.0 - share) * before.covariance_px2 + share * share * point.seen.covariance_px2;
  point.seen.shared_with_next_px2 =
      (1.0 - share) * (1.0 - share) * before.shared_with_next_px2 + share * share * point.seen.shared_with_next_px2;
  point.seen.saturated = point.seen.saturated || before.saturated;
  point.seen.weak = point.seen.weak || before.weak;
  point.velocity_px_per_s = (late.place_px - early.place_px) / seconds(late.at - early.at);
  point.timing_px2 =
      timing_of(point.velocity_px_per_s, moment.offset_sigma_s) + bend_px2(track, clock, early, late, share);
  return point;
}

/// Why a point has no place before its picture: nothing to say when it simply was not there yet.
Faults why_alone(const Track& track, const StampClock& clock, const Sample& sample) {
  const TrackedPicture& picture = track.picture(sample.back);
  if (picture.links[sample.index].ambiguous) return {Fault::kAmbiguous};
  const bool first = sample.back + 1 >= track.size();
  if (first || clock.time_of(picture.frame) - clock.time_of(track.picture(sample.back + 1).frame) > kLongestGap) {
    return {Fault::kTimingBound};
  }
  return {};
}

struct PointAtTime {
  std::optional<AlignedPoint> point;
  Faults faults;  // why there is none; empty when it simply was not there yet
  Sample oldest;  // that took part
};

PointAtTime point_at_time(const Track& track, const StampClock& clock, Sample late, const Moment& moment) {
  while (late.at - moment.time > kExact) {
    const std::optional<Sample> early = sample_before(track, clock, late);
    if (!early) return {std::nullopt, why_alone(track, clock, late), late};
    if (early->at <= moment.time && early->at < late.at) {
      if (late.at - early->at > kLongestGap) return {std::nullopt, {Fault::kTimingBound}, *early};
      return {between(track, clock, *early, late, moment), {}, *early};
    }
    late = *early;
  }
  return {exact(track, clock, late, moment.offset_sigma_s), {}, late};
}

/// The oldest picture that is not before `time`.
std::size_t picture_at_or_after(const Track& track, const StampClock& clock, TimePoint time) {
  std::size_t back = 0;
  while (back + 1 < track.size()) {
    const TrackedPicture& older = track.picture(back + 1);
    if (time_of_row(clock, older, older.first_row_px) + kExact < time) break;
    ++back;
  }
  return back;
}

/// When the exposure of a row began. No exposure is longer than the frame period.
TimePoint exposure_began(const StampClock& clock, const TrackedPicture& picture, double row_px) {
  const Duration longest = clock.period() > Duration{0} ? clock.period() : kLongestExposure;
  return time_of_row(clock, picture, row_px) - picture.exposure.value_or(longest) / 2;
}

}  // namespace

TimePoint time_of_row(const StampClock& clock, const TrackedPicture& picture, double row_px) {
  return clock.time_of(picture.frame) + duration_from_seconds(row_px * seconds(picture.line_time));
}

PointsAtTime points_at_time(const Track& track, const StampClock& clock, TimePoint time, double offset_sigma_s) {
  PointsAtTime found;
  const std::size_t back = picture_at_or_after(track, clock, time);
  found.picture = &track.picture(back);
  found.spots = found.picture->points.size();
  found.exposure_began = exposure_began(clock, *found.picture, found.picture->first_row_px);
  for (std::size_t i = 0; i < found.spots; ++i) {
    const Sample late = sample_of(track, clock, back, i);
    const PointAtTime one = point_at_time(track, clock, late, {time, offset_sigma_s});
    const double oldest_row_px = one.oldest.place_px.y();
    found.exposure_began =
        std::min(found.exposure_began, exposure_began(clock, track.picture(one.oldest.back), oldest_row_px));
    found.faults.insert(one.faults);
    if (one.point) found.points.push_back(*one.point);
  }
  // A spot that cannot be placed might have been the partner of one that the other camera sees. A label says which.
  const bool some_left_out =
      found.points.size() < found.spots && !found.points.empty() && !found.points[0].seen.label.has_value();
  if (some_left_out) found.faults.insert(Fault::kAmbiguous);
  return found;
}

}  // namespace tripoint
