#include "tags/tag_tracker.h"

#include <algorithm>
#include <utility>

#include "tags/tag_near.h"

namespace tripoint {
namespace {

constexpr std::uint32_t kMostFrames = 3;  // further ahead nothing is foreseen

bool is_kept(const SeenTag& tag) { return tag.outline.cause == TagCause::kKept; }

/// By id, as the decoder has them.
bool each_once(const SeenTags& seen) {
  return std::adjacent_find(seen.tags.begin(), seen.tags.end(), [](const SeenTag& a, const SeenTag& b) {
           return a.decoded.id == b.decoded.id;
         }) == seen.tags.end();
}

Vec2 between(const RawPixel& from, const RawPixel& to) { return {to.u_px - from.u_px, to.v_px - from.v_px}; }

}  // namespace

Result<TagTracker> TagTracker::open(const TagDetectorSettings& settings) {
  return TagDetector::open(settings).map([](TagDetector detector) { return TagTracker(std::move(detector)); });
}

const SeenTags& TagTracker::see(const Picture& picture) {
  if (!may_follow(picture) || !follow(picture)) decode(picture);
  return seen_;
}

bool TagTracker::may_follow(const Picture& picture) const {
  if (!last_ || picture.size != last_->size) return false;
  const std::uint32_t frames = picture.frame - last_->frame;
  return frames >= 1 && frames <= kMostFrames && picture.frame - last_->whole_frame < kFramesPerWhole &&
         !seen_.tags.empty() && !seen_.cut && each_once(seen_) &&
         std::all_of(seen_.tags.begin(), seen_.tags.end(), is_kept);
}

/// @return false when a tag is not where it is foreseen; those before it are followed already
bool TagTracker::follow(const Picture& picture) {
  const LumaView luma = luma_of(picture);
  for (std::size_t i = 0; i < seen_.tags.size(); ++i) {
    SeenTag& tag = seen_.tags[i];
    const double frames = picture.frame - ways_[i].frame;
    TagCornerPixels foreseen = tag.outline.corners_px;
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      foreseen[k].u_px += frames * ways_[i].steps_px[k].x();
      foreseen[k].v_px += frames * ways_[i].steps_px[k].y();
    }
    const std::optional<SeenTag> found = tag_near(luma, foreseen,
                                                  {.pattern = detector_.pattern(tag.decoded.id),
                                                   .id = tag.decoded.id,
                                                   .most_wrong_bits = tag.decoded.corrected_bits,
                                                   .min_margin = detector_.min_margin()});
    if (!found) return false;
    ways_[i] = way_to(*found, picture.frame);
    tag = *found;
  }
  seen_.coverage = Coverage::kRegions;
  last_->frame = picture.frame;
  return true;
}

void TagTracker::decode(const Picture& picture) {
  const SeenTags now = detector_.detect(picture);
  FixedVector<Way, kMaxDecodedTags> ways;
  for (const SeenTag& tag : now.tags) ways.push_back(way_to(tag, picture.frame));
  seen_ = now;
  ways_ = ways;
  last_ = {picture.frame, picture.frame, picture.size};
}

/// At rest when it was not seen shortly before.
TagTracker::Way TagTracker::way_to(const SeenTag& tag, std::uint32_t frame) const {
  Way way{.frame = frame};
  for (std::size_t i = 0; i < seen_.tags.size(); ++i) {
    const SeenTag& before = seen_.tags[i];
    const std::uint32_t frames = frame - ways_[i].frame;
    if (before.decoded.id != tag.decoded.id || frames > kMostFrames) continue;
    if (frames == 0) return ways_[i];
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      way.steps_px[k] = between(before.outline.corners_px[k], tag.outline.corners_px[k]) / frames;
    }
    return way;
  }
  return way;
}

}  // namespace tripoint
