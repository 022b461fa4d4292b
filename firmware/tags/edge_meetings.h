// Where the four edges of a tag meet, and how well that is known.
#pragma once

#include <array>

#include "tags/edge_line.h"
#include "values/forecast.h"
#include "values/linear.h"

namespace tripoint {

/// Edge k runs from corner k to the next one.
using Edges = std::array<EdgeLine, kTagCorners>;

/// Corner k: where edge k and the one before it meet.
struct Meeting {
  Vec2 at_px = Vec2::Zero();
  Matrix2 by_across = Matrix2::Identity();  ///< how it moves when the first and the second edge move across
};
using Meetings = std::array<Meeting, kTagCorners>;

/// @return kMovedCorner when two of them are almost parallel
TagCause meet_all(const Edges& edges, Meetings& meetings);

/// Whether light goes on evenly around each corner, on both sides of the edges.
bool light_goes_on(const Edges& edges);

/// Over u and v of corner 0, of corner 1 and so on.
using CornerCovariance = Eigen::Matrix<double, 2 * kTagCorners, 2 * kTagCorners>;

/// To first order in the place and the direction of each edge, eight errors that know nothing of each other.
CornerCovariance covariance_of(const Edges& edges, const Meetings& meetings);

}  // namespace tripoint
