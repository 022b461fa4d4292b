#include "line/align/track.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr double kFastest_px_per_frame = 120.0;  // 1 m/s at 400 mm and 628 px is 52 px in 1/30 s; 1280x720 doubles it
constexpr std::int32_t kMostSteps = 3;           // across more frames than that nothing is linked

bool is_finite(const ImagePoint& point) {
  return std::isfinite(point.at.u_px) && std::isfinite(point.at.v_px) && point.covariance_px2.allFinite();
}

Vec2 place_of(const ImagePoint& point) { return {point.at.u_px, point.at.v_px}; }

/// Known to be two LEDs.
bool differ(const ImagePoint& a, const ImagePoint& b) { return a.led != 0 && b.led != 0 && a.led != b.led; }

}  // namespace

const TrackedPicture& Track::picture(std::size_t back) const {
  TRIPOINT_ASSERT(back < size_);
  return ring_[(newest_ + kKept - back) % kKept];
}

void Track::take(const Observation& seen) {
  if (size_ > 0 && static_cast<std::int32_t>(seen.frame - picture(0).frame) <= 0) clear();
  newest_ = (newest_ + 1) % kKept;
  size_ = std::min(size_ + 1, kKept);
  TrackedPicture& now = slot(0);
  now.frame = seen.frame;
  now.line_time = seen.line_time;
  now.exposure = seen.exposure;
  now.health = seen.health;
  now.frames_dropped = size_ > 1 && seen.frame - picture(1).frame > 1 + seen.left_out;
  now.points.clear();
  for (const ImagePoint& point : seen.points) {
    if (is_finite(point)) now.points.push_back(point);
  }
  now.broken = now.points.size() < seen.points.size();
  if (seen.coverage == Coverage::kWholeFrame) {
    whole_ = Whole{now.frame, now.points.size(), !now.health.candidates_cut};
  }
  now.unwatched = seen.coverage == Coverage::kRegions && !now.points.empty() && !watched(now);
  now.first_row_px = size_ > 1 ? picture(1).first_row_px : 0.0;
  if (!now.points.empty()) {
    now.first_row_px = std::min_element(now.points.begin(), now.points.end(), [](const auto& a, const auto& b) {
                         return a.at.v_px < b.at.v_px;
                       })->at.v_px;
  }
  link_to_picture_before(now);
}

bool Track::watched(const TrackedPicture& regions) const {
  return whole_ && regions.frame - whole_->frame < kFramesPerWhole && whole_->to_the_end &&
         whole_->points <= regions.points.size();
}

void Track::link_to_picture_before(TrackedPicture& now) const {
  now.links.clear();
  now.step_px.clear();
  for (std::size_t i = 0; i < now.points.size(); ++i) now.step_px.push_back(Vec2::Zero());
  const std::int32_t steps = size_ > 1 ? static_cast<std::int32_t>(now.frame - picture(1).frame) : 0;
  if (steps == 0 || steps > kMostSteps) {
    for (std::size_t i = 0; i < now.points.size(); ++i) now.links.push_back(Link{});
    return;
  }
  const TrackedPicture& before = picture(1);
  FixedVector<Vec2, kMaxImagePoints> expected;
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    expected.push_back(place_of(before.points[i]) + steps * before.step_px[i]);
  }
  FixedVector<Vec2, kMaxImagePoints> places;
  for (const ImagePoint& point : now.points) places.push_back(place_of(point));
  const double gate_px = kFastest_px_per_frame * steps;
  const std::span<const Vec2> where{expected.begin(), expected.size()};
  const bool labelled = !now.points.empty() && now.points[0].label.has_value();
  now.links = labelled ? linked_by_label({before.points.begin(), before.points.size()}, where,
                                         {now.points.begin(), now.points.size()}, gate_px)
                       : linked(where, {places.begin(), places.size()}, gate_px);
  for (std::size_t i = 0; i < now.links.size(); ++i) {
    Link& link = now.links[i];
    if (link.before && differ(before.points[*link.before], now.points[i])) link = Link{.before = {}, .ambiguous = true};
    if (link.before) now.step_px[i] = (places[i] - place_of(before.points[*link.before])) / steps;
  }
}

}  // namespace tripoint
