#include "line/pose/timing_part.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace tripoint {

Matrix32 pixel_gain_mm_per_px(const Rig& rig, const TriangulatedPoint& point, const PerSide<MeasuredPixel>& seen,
                              Side side) {
  const Isometry3& camera_from_rig = rig.camera_from_rig[side];
  const Matrix23 jacobian =
      projection_jacobian_px_per_mm(rig.cameras[side], camera_from_rig * point.in_rig_mm) * camera_from_rig.linear();
  return point.covariance_mm2 * jacobian.transpose() * seen[side].covariance_px2.inverse();
}

Matrix2 timing_root_px(const Matrix2& timing_px2, const std::optional<Vec2>& velocity_px_per_s) {
  const bool moves = velocity_px_per_s && velocity_px_per_s->norm() > 0.0;
  const Vec2 along = moves ? Vec2(velocity_px_per_s->normalized()) : Vec2(Vec2::UnitX());
  const Vec2 across(-along.y(), along.x());
  Matrix2 root = Matrix2::Zero();
  const double along_px2 = along.dot(timing_px2 * along);
  if (along_px2 > 0.0) root.col(0) = timing_px2 * along / std::sqrt(along_px2);
  const Matrix2 rest = timing_px2 - root.col(0) * root.col(0).transpose();  // nothing of it lies along
  root.col(1) = across * std::sqrt(std::max(0.0, across.dot(rest * across)));
  return root;
}

}  // namespace tripoint
