// A straight edge between dark and light, measured along its whole length.
#pragma once

#include <cstddef>

#include "tags/luma_view.h"
#include "tags/tag_cause.h"
#include "values/linear.h"

namespace tripoint {

inline constexpr std::size_t kMostCrossings = 48;

/// Roughly where an edge is; on the right of its direction, as the picture is shown, lies the outside.
struct RoughEdge {
  Vec2 from_px = Vec2::Zero();
  Vec2 to_px = Vec2::Zero();
  bool light_inside = false;
  double reach_px = 2.0;         ///< how far to both sides nothing but this edge is to be seen
  double most_scatter_px = 0.5;  ///< of the crossings about the line; more, and it is no straight edge
  bool even_light = true;        ///< asked for on both sides along the edge
  std::size_t most_crossings = kMostCrossings;
};

/// Luma beside an edge, at the ends of what is looked at across it.
struct LightBeside {
  double mean = 0.0;
  double at_from = 0.0;  ///< beside the edge's beginning; along the edge light may change evenly
  double at_to = 0.0;    ///< beside its end
  double scatter = 0.0;  ///< standard deviation from that even change
};

struct EdgeLine {
  Vec2 middle_px = Vec2::Zero();     ///< of what was measured, on the line
  Vec2 along = Vec2::UnitX();        ///< unit length
  double across_variance_px2 = 0.0;  ///< of the middle, across the line
  double angle_variance_rad2 = 0.0;  ///< of the direction
  LightBeside light;                 ///< on the light side
  LightBeside dark;
};

struct EdgeFit {
  TagCause cause = TagCause::kKept;
  EdgeLine line;  ///< only of a kept one
};

/// Crossings of lines across the edge, each the centroid of the luma's slope, which a symmetric blur does not move; and
/// the straight line through them by least squares, without those beyond three deviations. The variances come from how
/// the crossings scatter about the line.
///
/// @return kTooSmall, kCutByBorder, kNoContrast, kCrookedEdge, kBlurred or kUnevenLight when there is no such edge
EdgeFit edge_line(const LumaView& luma, const RoughEdge& edge);

}  // namespace tripoint
