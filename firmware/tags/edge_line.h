// A straight edge between dark and light, measured along its whole length.
#pragma once

#include "tags/luma_copy.h"
#include "tags/tag_cause.h"
#include "values/linear.h"

namespace tripoint {

/// Roughly where an edge is; on the right of its direction, as the picture is shown, lies the outside.
struct RoughEdge {
  Vec2 from_px = Vec2::Zero();
  Vec2 to_px = Vec2::Zero();
  bool light_inside = false;
  double reach_px = 2.0;         ///< how far to both sides nothing but this edge is to be seen
  double most_scatter_px = 0.5;  ///< of the crossings about the line; more, and it is no straight edge
};

struct EdgeLine {
  Vec2 middle_px = Vec2::Zero();     ///< of what was measured, on the line
  Vec2 along = Vec2::UnitX();        ///< unit length
  double across_variance_px2 = 0.0;  ///< of the middle, across the line
  double angle_variance_rad2 = 0.0;  ///< of the direction
  double light = 0.0;                ///< mean luma of the light side
  double dark = 0.0;                 ///< of the dark side
};

struct EdgeFit {
  TagCause cause = TagCause::kKept;
  EdgeLine line;  ///< only of a kept one
};

/// Crossings of lines across the edge, each the centroid of the luma's slope, which a symmetric blur does not move; and
/// the straight line through them by least squares, without those beyond three deviations. The variances come from how
/// the crossings scatter about the line.
///
/// @return kTooSmall, kCutByBorder, kNoContrast, kCrookedEdge or kBlurred when there is no such edge
EdgeFit edge_line(const LumaCopy& luma, const RoughEdge& edge);

}  // namespace tripoint
