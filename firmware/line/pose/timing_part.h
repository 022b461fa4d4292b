// What an error of the clocks does to a point.
#pragma once

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

}  // namespace tripoint
