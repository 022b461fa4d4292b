// The other way in which a flat target may be tilted and look almost the same.
#pragma once

#include <span>

#include "values/linear.h"

namespace tripoint {

/// The pose mirrored at the plane through the points' middle that faces the rig's origin. Seen from far away, flat
/// points look the same in both.
///
/// @param in_target_mm  three or more, not on a line; of points that are not flat, their best plane counts
/// Source: Oberkampf, DeMenthon & Davis 1996, "Iterative pose estimation using coplanar feature points".
Isometry3 tilted_over(const Isometry3& rig_from_target, std::span<const Vec3> in_target_mm);

/// By how much the second pose is turned against the first, 0 to pi.
double turn_between_rad(const Isometry3& one, const Isometry3& other);

/// How far from a tilt a fit may end that was to stay there: half the way to the other tilt, or four standard
/// deviations of all directions together where the two tilts are one for all that noise can tell.
double reach_of_tilt_rad(const Isometry3& tilt, const Isometry3& other, const Matrix3& turn_covariance_rad2);

}  // namespace tripoint
