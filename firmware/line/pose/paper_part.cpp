#include "line/pose/paper_part.h"

#include "geometry/paper.h"

namespace tripoint {
namespace {

constexpr double kPixelStep_px = 1e-3;
constexpr double kAnyAngle_rad = 1e-9;  // a step must not fall out of the range that the point itself lies in

/// Small enough that the second order is below 1e-6, large enough for rounding: of fx fy cx cy in px, of the
/// distortion, of the rotation in rad, of the translation in mm.
RigParameters steps() {
  RigParameters steps;
  steps << 1e-3, 1e-3, 1e-3, 1e-3, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3, 1e-3, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6,
      1e-6, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3;
  return steps;
}

}  // namespace

Matrix32 pixel_gain_by_paper(const Rig& rig, const PerSide<MeasuredPixel>& seen, Side side) {
  Matrix32 gain = Matrix32::Zero();
  for (int axis = 0; axis < 2; ++axis) {
    const auto at = [&](double step_px) {
      PerSide<MeasuredPixel> there = seen;
      (axis == 0 ? there[side].at.u_px : there[side].at.v_px) += step_px;
      return triangulated_by_paper(rig, there, kAnyAngle_rad);
    };
    const Result<TriangulatedPoint> before = at(-kPixelStep_px);
    const Result<TriangulatedPoint> after = at(kPixelStep_px);
    if (before && after) gain.col(axis) = (after->in_rig_mm - before->in_rig_mm) / (2.0 * kPixelStep_px);
  }
  return gain;
}

Eigen::Matrix<double, 3, 24> calibration_jacobian_by_paper(const StereoCalibration& calibration,
                                                           const PerSide<MeasuredPixel>& seen) {
  const RigParameters parameters = parameters_of(calibration);
  const PerSide<ImageSize> sizes{calibration.cameras.left.size, calibration.cameras.right.size};
  const RigParameters step = steps();
  Eigen::Matrix<double, 3, 24> jacobian = Eigen::Matrix<double, 3, 24>::Zero();
  for (int i = 0; i < 24; ++i) {
    const auto at = [&](double sign) -> Result<TriangulatedPoint> {
      RigParameters there = parameters;
      there[i] += sign * step[i];
      const Result<Rig> rig = rig_of(calibration_of(there, sizes));
      if (!rig) return tl::make_unexpected(rig.error());
      return triangulated_by_paper(*rig, seen, kAnyAngle_rad);
    };
    const Result<TriangulatedPoint> before = at(-1.0);
    const Result<TriangulatedPoint> after = at(1.0);
    if (before && after) jacobian.col(i) = (after->in_rig_mm - before->in_rig_mm) / (2.0 * step[i]);
  }
  return jacobian;
}

}  // namespace tripoint
