#include "line/pose/timing_part.h"

#include <Eigen/LU>

namespace tripoint {

Matrix32 pixel_gain_mm_per_px(const Rig& rig, const TriangulatedPoint& point, const PerSide<MeasuredPixel>& seen,
                              Side side) {
  const Isometry3& camera_from_rig = rig.camera_from_rig[side];
  const Matrix23 jacobian =
      projection_jacobian_px_per_mm(rig.cameras[side], camera_from_rig * point.in_rig_mm) * camera_from_rig.linear();
  return point.covariance_mm2 * jacobian.transpose() * seen[side].covariance_px2.inverse();
}

}  // namespace tripoint
