#include "tags/edge_meetings.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

// Between two edges, of the contrast, where they meet. A cover along a whole edge changes the light beside that one
// alone.
constexpr double kMostUnlike = 0.12;
constexpr double kLeastSine = 0.17;  // of the angle between two edges: 10 degrees

/// Corner k lies on edge k and on the one before it.
std::size_t edge_before(std::size_t corner) { return (corner + kTagCorners - 1) % kTagCorners; }

/// n1 x = n1 m1, n2 x = n2 m2.
TagCause meet(const EdgeLine& one, const EdgeLine& other, Meeting& meeting) {
  Matrix2 normals;
  normals << -one.along.y(), one.along.x(), -other.along.y(), other.along.x();
  if (std::abs(normals.determinant()) < kLeastSine) return TagCause::kMovedCorner;
  meeting.by_across = normals.inverse();
  meeting.at_px = meeting.by_across * Vec2(normals.row(0).dot(one.middle_px), normals.row(1).dot(other.middle_px));
  return TagCause::kKept;
}

}  // namespace

TagCause meet_all(const Edges& edges, Meetings& meetings) {
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const TagCause cause = meet(edges[edge_before(k)], edges[k], meetings[k]);
    if (cause != TagCause::kKept) return cause;
  }
  return TagCause::kKept;
}

bool light_goes_on(const Edges& edges) {
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const EdgeLine& before = edges[edge_before(k)];
    const EdgeLine& after = edges[k];
    const double most =
        kMostUnlike * std::min(before.light.mean - before.dark.mean, after.light.mean - after.dark.mean);
    if (!(std::abs(before.light.at_to - after.light.at_from) <= most)) return false;
    if (!(std::abs(before.dark.at_to - after.dark.at_from) <= most)) return false;
  }
  return true;
}

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

}  // namespace tripoint
