#include "tags/tag_corners.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/diagonals.h"
#include "tags/cell_shift.h"

namespace tripoint {
namespace {

using Places = std::array<Vec2, kTagCorners>;

// Of a cell of the tag: next to the edge lies one cell of each brightness.
constexpr double kFirstReach_cells = 0.9;
constexpr double kLastReach_cells = 0.75;
constexpr double kFirstReach_px = 3.0;    // the decoder's corners are within that
constexpr double kLastReach_px = 2.5;     // blur of a lens in focus ends there
constexpr double kFirstScatter_px = 1.5;  // the decoder's edge is at a slant to the true one
constexpr double kMostScatter_px = 0.5;   // what is known to 0.03 px in a sharp picture
constexpr double kSmallestReach_px = 1.0;
constexpr std::size_t kFewForForecast = 8;  // crossings of an edge, to find it before it is measured
constexpr double kRough_px = 1.0;           // standard deviation of the decoder's corners
constexpr double kMoved_px = 1.0;           // between the decoder's corner and the measured one: more is another edge

Vec2 place_of(const RawPixel& pixel) { return {pixel.u_px, pixel.v_px}; }

double shortest_edge_px(const Places& corners) {
  double shortest_px = (corners[0] - corners.back()).norm();
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    shortest_px = std::min(shortest_px, (corners[k + 1] - corners[k]).norm());
  }
  return shortest_px;
}

/// How the edges are looked at once.
struct Pass {
  double reach_px = 0.0;
  double most_scatter_px = 0.0;
  bool even_light = false;
  std::size_t most_crossings = kMostCrossings;
};

TagCause measure(const LumaView& luma, const Places& corners, bool light_inside, const Pass& pass, Edges& edges) {
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const EdgeFit fit = edge_line(luma, {.from_px = corners[k],
                                         .to_px = corners[(k + 1) % kTagCorners],
                                         .light_inside = light_inside,
                                         .reach_px = pass.reach_px,
                                         .most_scatter_px = pass.most_scatter_px,
                                         .even_light = pass.even_light,
                                         .most_crossings = pass.most_crossings});
    if (fit.cause != TagCause::kKept) return fit.cause;
    edges[k] = fit.line;
  }
  return TagCause::kKept;
}

double reach(double cell_px, double cells, double most_px) {
  return std::clamp(cells * cell_px, kSmallestReach_px, most_px);
}

RawPixel pixel_at(const Vec2& place_px) { return {place_px.x(), place_px.y()}; }

/// How far to look: first for what is only roughly known, then where it was found.
struct Reaches {
  double first_px = 0.0;
  double last_px = 0.0;
};

Reaches reaches_of(const Places& corners_px, const TagPattern& pattern) {
  const double cell_px = shortest_edge_px(corners_px) / pattern.cells_across;
  return {reach(cell_px, kFirstReach_cells, kFirstReach_px), reach(cell_px, kLastReach_cells, kLastReach_px)};
}

/// Looks at the edges again and again, each time where they were found before.
///
/// @return only a cause when they cannot be measured
TagOutline found_from(const LumaView& luma, const Places& start_px, const TagPattern& pattern,
                      std::span<const Pass> passes) {
  TagOutline outline;
  Places corners_px = start_px;
  Edges edges;
  Meetings meetings;
  for (const Pass& pass : passes) {
    outline.cause = measure(luma, corners_px, pattern.light_inside, pass, edges);
    if (outline.cause == TagCause::kKept) outline.cause = meet_all(edges, meetings);
    if (outline.cause != TagCause::kKept) return outline;
    for (std::size_t k = 0; k < kTagCorners; ++k) corners_px[k] = meetings[k].at_px;
  }
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    outline.corners_px[k] = pixel_at(corners_px[k]);
    outline.light += edges[k].light.mean / kTagCorners;
    outline.dark += edges[k].dark.mean / kTagCorners;
    outline.lightest = std::max(outline.lightest, edges[k].light.mean);
  }
  if (!light_goes_on(edges)) {
    outline.cause = TagCause::kUnevenLight;
  } else if (!cells_agree(luma, pattern, TagPlane(corners_px), outline.light - outline.dark)) {
    outline.cause = TagCause::kShiftedCells;
  }
  outline.covariance_px2 = covariance_of(edges, meetings);
  return outline;
}

}  // namespace

Places places_of(const TagCornerPixels& corners_px) {
  Places places;
  std::transform(corners_px.begin(), corners_px.end(), places.begin(), place_of);
  return places;
}

TagOutline rough_outline(const DecodedTag& tag, TagCause cause) {
  return {cause, tag.corners_px, kRough_px * kRough_px * CornerCovariance::Identity(), 0.0, 0.0, 0.0};
}

TagOutline tag_outline(const LumaView& luma, const DecodedTag& tag, const TagPattern& pattern) {
  const Places start_px = places_of(tag.corners_px);
  const Reaches reaches = reaches_of(start_px, pattern);
  const std::array<Pass, 3> passes{
      {{.reach_px = reaches.first_px, .most_scatter_px = kFirstScatter_px},
       {.reach_px = reaches.last_px, .most_scatter_px = kFirstScatter_px},
       {.reach_px = reaches.last_px, .most_scatter_px = kMostScatter_px, .even_light = true}}};
  const TagOutline outline = found_from(luma, start_px, pattern, passes);
  if (outline.cause != TagCause::kKept) return rough_outline(tag, outline.cause);
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec2 moved_px = place_of(outline.corners_px[k]) - start_px[k];
    if (!(moved_px.norm() <= kMoved_px)) return rough_outline(tag, TagCause::kMovedCorner);
  }
  return outline;
}

TagOutline outline_near(const LumaView& luma, const TagCornerPixels& foreseen, const TagPattern& pattern) {
  const Places start_px = places_of(foreseen);
  const Reaches reaches = reaches_of(start_px, pattern);
  const std::array<Pass, 2> passes{
      {{.reach_px = reaches.first_px, .most_scatter_px = kFirstScatter_px, .most_crossings = kFewForForecast},
       {.reach_px = reaches.last_px, .most_scatter_px = kMostScatter_px, .even_light = true}}};
  return found_from(luma, start_px, pattern, passes);
}

MeasuredPlace corner_of(const TagOutline& outline, std::size_t corner) {
  const auto at = static_cast<Eigen::Index>(2 * corner);
  return {outline.corners_px[corner], outline.covariance_px2.block<2, 2>(at, at)};
}

MeasuredPlace centre_of(const TagOutline& outline) {
  const DiagonalCrossing centre = diagonals_of(places_of(outline.corners_px));
  return {pixel_at(centre.at), centre.by_corners * outline.covariance_px2 * centre.by_corners.transpose()};
}

}  // namespace tripoint
