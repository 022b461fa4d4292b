// Corners of a tag as a lens without distortion would show them, brought back into the picture as it is.
#pragma once

#include <array>

#include "geometry/camera_model.h"
#include "values/forecast.h"
#include "values/pixel.h"

namespace tripoint {

/// The detector lays a straight line along each edge; a lens bends edges, so that the lines meet beside the corners, on
/// a tag of 50 px near the border by a tenth of a pixel. Here the same is done to edges that this lens bends, and what
/// it moves their corners by is taken off.
///
/// @param seen  corners in order around the tag, where straight lines along its edges meet
/// @return the pictures of the corners themselves; kNoConvergence when a corner cannot be undistorted
Result<std::array<RawPixel, kTagCorners>> straight_corners(const CameraModel& camera,
                                                           const std::array<RawPixel, kTagCorners>& seen);

}  // namespace tripoint
