// What one pixel sees of a printed tag at one instant: its cells, softened as the lens and the pixels soften them.
#pragma once

#include <optional>

#include "sim/normal_integral.h"
#include "sim/pixel_rays.h"
#include "sim/printed_tag.h"
#include "values/linear.h"

namespace tripoint {

inline constexpr int kMostTagCells = 16;  ///< across a print; no family of libapriltag has more than 12

/// A tag before a camera.
struct TagSight {
  Matrix3 cells_from_direction = Matrix3::Identity();  ///< homogeneous; in cells from the upper left of the print
  bool front = true;                                   ///< otherwise the camera sees its back
};

/// @return nothing when the tag is seen edge-on
std::optional<TagSight> sight_of(const PrintedTag& tag, const Isometry3& camera_from_tag);

struct TagCover {
  double share = 0.0;  ///< of the pixel that the paper covers
  double light = 0.0;  ///< what that share reflects of white light
};

/// Edges are steps seen through a Gaussian blur whose width follows the view at this very pixel. A symmetric blur does
/// not move an edge, so the middle of a step lies where the camera projects it; where edges cross, the blur along one
/// is taken as independent of that along the other.
///
/// @param blur_px  standard deviation, the pixel's own width included
TagCover cover_at(const PixelRay& ray, const PrintedTag& tag, const TagSight& sight, double blur_px,
                  const NormalIntegral& normal);

}  // namespace tripoint
