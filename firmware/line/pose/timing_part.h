// What an error of the clocks does to a point.
#pragma once

#include <optional>

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

/// d(maximum-likelihood point in rig, mm) / d(pixel of one camera), mm per px.
///
/// @param point  in front of both cameras, with the covariance that `seen` gives it
Matrix32 pixel_gain_mm_per_px(const Rig& rig, const TriangulatedPoint& point, const PerSide<MeasuredPixel>& seen,
                              Side side);

/// A square root of what time adds to a point's covariance: the first column along the point's velocity, or along u
/// while it is unknown, so that one clock's error has the same sign in all points; the second across it.
///
/// @param timing_px2  positive semi-definite
/// @return            root with root root' = timing_px2
Matrix2 timing_root_px(const Matrix2& timing_px2, const std::optional<Vec2>& velocity_px_per_s);

}  // namespace tripoint
