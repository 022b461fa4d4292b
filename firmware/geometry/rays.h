// Where two pixels look: the start of every triangulation.
#pragma once

#include "geometry/rig.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// A viewing ray: from a lens centre along a unit direction.
struct Ray {
  NormalizedPoint at;  ///< the same direction in the camera's own frame
  Vec3 center_in_rig_mm = Vec3::Zero();
  Vec3 direction_in_rig = Vec3::UnitZ();
};

/// @return kNoConvergence when a pixel cannot be undistorted
Result<PerSide<Ray>> rays_of(const Rig& rig, const PerSide<RawPixel>& pixels);

/// Angle between the two directions, 0 to pi rad.
double angle_between_rad(const PerSide<Ray>& rays);

/// Middle of the shortest segment between the rays' lines. The rays must not be parallel.
/// Source: Hartley & Sturm 1997, "Triangulation" (midpoint method).
Vec3 midpoint_in_rig_mm(const PerSide<Ray>& rays);

/// Whether a point has positive depth in both cameras.
bool in_front_of_both(const Rig& rig, const Vec3& point_in_rig_mm);

}  // namespace tripoint
