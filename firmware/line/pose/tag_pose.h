// From pairs of tags' corners to points in space, and to the target's pose.
#pragma once

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/model.h"
#include "line/pose/pose.h"

namespace tripoint {

/// The rigid fit of all corners in both pictures; one tag is enough. By the paper's method the frame of three tags'
/// centres, which are found where the diagonals meet in each picture. Each tag's centre is a point of the verdict.
///
/// One picture alone gives a pose of tags as well, but then nothing tells whether they are the target's. So the timing
/// counts as for a point of both pictures, `timing_sigma_mm`, however little it moves the pose.
///
/// Flat corners that are tilted towards one side look almost like those tilted towards the other. Both are tried, and
/// the pose is one that stayed at the likelier of them (`reach_of_tilt_rad`).
///
/// Nothing but the whole fit tells that a tag sits elsewhere than the target says, or has another size: all corners
/// together must be likelier than once in 1,000 (`whole_fit`).
///
/// @param pairs  by `match_tags`: four corners of each tag
/// @return kGeometryGate       rays do not meet in front of both cameras, or the corners do not make the target: other
///                             sizes or places of the tags than the target says, a bent plate, a tag from behind
///         kAmbiguous          the target may as well be tilted the other way: its chi-square is less than 10 worse, or
///                             cannot be told because the iteration does not get there; or the pose left its tilt
///         kNotSeenLeft/Right  by the paper's method fewer than three tags, or all of them nearly on a line
Fit pose_of_tags(const Aligned& seen, const Pairs& pairs, const LineModel& model);

}  // namespace tripoint
