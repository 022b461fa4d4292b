// Whether the cells inside a tag lie where its corners put them.
#pragma once

#include "tags/luma_view.h"
#include "tags/tag_pattern.h"
#include "tags/tag_plane.h"

namespace tripoint {

/// A cover along an edge of the tag is an edge too, and moves two corners; all bits may still be right. But it does not
/// move the cells within. Where light cells meet dark ones is measured as an edge is, at one place for each side that
/// they share, along x and along y of the tag; a plane through these shifts says by how much each corner is off.
///
/// @param plane     as the corners have it
/// @param contrast  of the tag's edges, luma steps
/// @return false when a corner is off by more than 0.1 px and three deviations, or too few sides of cells can be seen
bool cells_agree(const LumaView& luma, const TagPattern& pattern, const TagPlane& plane, double contrast);

}  // namespace tripoint
