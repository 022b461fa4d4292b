// Seen tags as what the line takes: image points with labels.
#pragma once

#include <span>

#include "line/observation.h"
#include "tags/tag_detector.h"

namespace tripoint {

struct TagPoints {
  FixedVector<ImagePoint, kMaxImagePoints> points;  ///< four for each tag, in the order of its corners
  ImageHealth health;                               ///< candidates_cut: there were more than there is room for
};

/// Each corner with 0.05 px beside what its edges say: cameras shift whole edges.
/// Of the kept tags those whose id is wanted; of an id that was decoded twice all, also the rough ones: the line
/// refuses that.
TagPoints points_of(const SeenTags& seen, std::span<const int> wanted_ids);

/// Whether the light side of any of a tag's edges clips: it then seems to lie too far in the dark.
bool clips(const TagOutline& outline);

}  // namespace tripoint
