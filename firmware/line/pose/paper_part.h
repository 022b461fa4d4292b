// How the paper's point follows what it is made of; by central differences, since its equations are not the likeliest.
#pragma once

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "line/pose/timing_part.h"
#include "values/side.h"

namespace tripoint {

/// d(point in rig, mm) / d(pixel of one camera), mm per px; zero where the paper's method gives no point.
Matrix32 pixel_gain_by_paper(const Rig& rig, const PerSide<MeasuredPixel>& seen, Side side);

/// d(point in rig, mm) / d(calibration parameters), the reference frame moving with them; zero where there is no point.
Eigen::Matrix<double, 3, 24> calibration_jacobian_by_paper(const StereoCalibration& calibration,
                                                           const PerSide<MeasuredPixel>& seen);

}  // namespace tripoint
