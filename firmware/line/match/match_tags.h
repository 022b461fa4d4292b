// Which corners of tags the two pictures share: their labels say it, and geometry has to agree.
#pragma once

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/model.h"

namespace tripoint {

/// Pairs of the target's tags, four corners each in the order of their labels. A tag counts when both pictures show all
/// of its corners (`straight_corners` of what was seen), each within the epipolar gate; what only one picture shows is
/// left out.
///
/// @return kNotSeenLeft/Right  a tag of the target in the other picture, but none in both;  kEpipolarGate  a corner's
///         rays do not meet: another tag of the same id, or one in a mirror;  kAmbiguous  a tag that is there twice;
///         kGeometryGate  a corner where the lens model has no viewing ray
Pairs match_tags(const Aligned& seen, const LineModel& model);

}  // namespace tripoint
