#include "tags/tag_corners.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/diagonals.h"
#include "tags/edge_line.h"

namespace tripoint {
namespace {

using Places = std::array<Vec2, kTagCorners>;
using Edges = std::array<EdgeLine, kTagCorners>;

// Of a cell of the tag: next to the edge lies one cell of each brightness.
constexpr double kFirstReach_cells = 0.9;
constexpr double kLastReach_cells = 0.75;
constexpr double kFirstReach_px = 3.0;    // the decoder's corners are within that
constexpr double kLastReach_px = 2.5;     // blur of a lens in focus ends there
constexpr double kFirstScatter_px = 1.5;  // the decoder's edge is at a slant to the true one
constexpr double kMostScatter_px = 0.5;   // what is known to 0.03 px in a sharp picture
constexpr double kSmallestReach_px = 1.0;
constexpr double kLeastSine = 0.17;  // of the angle between two edges: 10 degrees
constexpr double kRough_px = 1.0;    // standard deviation of the decoder's corners
constexpr double kMoved_px = 1.0;    // between the decoder's corner and the measured one: more is another edge

Vec2 place_of(const RawPixel& pixel) { return {pixel.u_px, pixel.v_px}; }

double shortest_edge_px(const Places& corners) {
  double shortest_px = (corners[0] - corners.back()).norm();
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    shortest_px = std::min(shortest_px, (corners[k + 1] - corners[k]).norm());
  }
  return shortest_px;
}

/// How an edge is looked at: first where the decoder says it is, then where it was measured.
struct Pass {
  double reach_px = 0.0;
  double most_scatter_px = 0.0;
};

/// Edge k runs from corner k to the next one.
TagCause measure(const LumaCopy& luma, const Places& corners, bool light_inside, const Pass& pass, Edges& edges) {
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const EdgeFit fit = edge_line(
        luma, {corners[k], corners[(k + 1) % kTagCorners], light_inside, pass.reach_px, pass.most_scatter_px});
    if (fit.cause != TagCause::kKept) return fit.cause;
    edges[k] = fit.line;
  }
  return TagCause::kKept;
}

/// Corner k lies on edge k and on the one before it.
std::size_t edge_before(std::size_t corner) { return (corner + kTagCorners - 1) % kTagCorners; }

/// Where two edges meet: n1 x = n1 m1, n2 x = n2 m2.
struct Meeting {
  Vec2 at_px = Vec2::Zero();
  Matrix2 by_across = Matrix2::Identity();  ///< how it moves when the first and the second edge move across
};
using Meetings = std::array<Meeting, kTagCorners>;

TagCause meet(const EdgeLine& one, const EdgeLine& other, Meeting& meeting) {
  Matrix2 normals;
  normals << -one.along.y(), one.along.x(), -other.along.y(), other.along.x();
  if (std::abs(normals.determinant()) < kLeastSine) return TagCause::kMovedCorner;
  meeting.by_across = normals.inverse();
  meeting.at_px = meeting.by_across * Vec2(normals.row(0).dot(one.middle_px), normals.row(1).dot(other.middle_px));
  return TagCause::kKept;
}

TagCause meet_all(const Edges& edges, Meetings& meetings) {
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const TagCause cause = meet(edges[edge_before(k)], edges[k], meetings[k]);
    if (cause != TagCause::kKept) return cause;
  }
  return TagCause::kKept;
}

/// To first order in the place and the direction of each edge, eight errors that know nothing of each other.
CornerCovariance covariance_of(const Edges& edges, const Meetings& meetings) {
  CornerCovariance corner_by_edge = CornerCovariance::Zero();
  Eigen::Matrix<double, 2 * kTagCorners, 1> variances;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const auto row = static_cast<Eigen::Index>(2 * k);
    const std::array<std::size_t, 2> meeting_edges{edge_before(k), k};
    for (std::size_t side = 0; side < 2; ++side) {
      const EdgeLine& edge = edges[meeting_edges[side]];
      const auto column = static_cast<Eigen::Index>(2 * meeting_edges[side]);
      const double away_px = (meetings[k].at_px - edge.middle_px).dot(edge.along);
      const Vec2 by_across = meetings[k].by_across.col(static_cast<Eigen::Index>(side));
      corner_by_edge.block<2, 1>(row, column) = by_across;
      corner_by_edge.block<2, 1>(row, column + 1) = away_px * by_across;
    }
    variances.segment<2>(row) << edges[k].across_variance_px2, edges[k].angle_variance_rad2;
  }
  return corner_by_edge * variances.asDiagonal() * corner_by_edge.transpose();
}

double reach(double cell_px, double cells, double most_px) {
  return std::clamp(cells * cell_px, kSmallestReach_px, most_px);
}

RawPixel pixel_at(const Vec2& place_px) { return {place_px.x(), place_px.y()}; }

}  // namespace

TagOutline rough_outline(const DecodedTag& tag, TagCause cause) {
  return {cause, tag.corners_px, kRough_px * kRough_px * CornerCovariance::Identity(), 0.0, 0.0, 0.0};
}

TagOutline tag_outline(const LumaCopy& luma, const DecodedTag& tag, const TagShape& shape) {
  Places corners_px;
  std::transform(tag.corners_px.begin(), tag.corners_px.end(), corners_px.begin(), place_of);
  const double cell_px = shortest_edge_px(corners_px) / shape.cells_across;
  const Pass first{reach(cell_px, kFirstReach_cells, kFirstReach_px), kFirstScatter_px};
  const Pass last{reach(cell_px, kLastReach_cells, kLastReach_px), kMostScatter_px};
  TagOutline outline;
  Edges edges;
  Meetings meetings;
  for (const Pass& pass : {first, {last.reach_px, kFirstScatter_px}, last}) {
    outline.cause = measure(luma, corners_px, shape.light_inside, pass, edges);
    if (outline.cause == TagCause::kKept) outline.cause = meet_all(edges, meetings);
    if (outline.cause != TagCause::kKept) return rough_outline(tag, outline.cause);
    for (std::size_t k = 0; k < kTagCorners; ++k) corners_px[k] = meetings[k].at_px;
  }
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec2 moved_px = meetings[k].at_px - place_of(tag.corners_px[k]);
    if (!(moved_px.norm() <= kMoved_px)) return rough_outline(tag, TagCause::kMovedCorner);
    outline.corners_px[k] = pixel_at(meetings[k].at_px);
    outline.light += edges[k].light / kTagCorners;
    outline.dark += edges[k].dark / kTagCorners;
    outline.lightest = std::max(outline.lightest, edges[k].light);
  }
  outline.covariance_px2 = covariance_of(edges, meetings);
  return outline;
}

MeasuredPlace corner_of(const TagOutline& outline, std::size_t corner) {
  const auto at = static_cast<Eigen::Index>(2 * corner);
  return {outline.corners_px[corner], outline.covariance_px2.block<2, 2>(at, at)};
}

MeasuredPlace centre_of(const TagOutline& outline) {
  Places corners_px;
  std::transform(outline.corners_px.begin(), outline.corners_px.end(), corners_px.begin(), place_of);
  const DiagonalCrossing centre = diagonals_of(corners_px);
  return {pixel_at(centre.at), centre.by_corners * outline.covariance_px2 * centre.by_corners.transpose()};
}

}  // namespace tripoint
