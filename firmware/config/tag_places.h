// Where the corners of a target's tags lie, and which tags are in each other's way.
#pragma once

#include <array>

#include "config/target_file.h"
#include "values/linear.h"

namespace tripoint {

/// In the target's frame, in order around the tag.
std::array<Vec3, 4> corners_mm(const TargetFileTag& tag);

/// Whether two tags cut through each other, or one lies on or closely before the other, both facing the same way:
/// within half of the larger size. Back to back they may lie together.
///
/// Source: Gottschalk, Lin & Manocha 1996, "OBBTree" (separating axes).
bool overlap(const TargetFileTag& one, const TargetFileTag& other);

/// Between any corner of one and any of the other.
double farthest_mm(const TargetFileTag& one, const TargetFileTag& other);

}  // namespace tripoint
