#include "geometry/triangulation.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/rays.h"

namespace tripoint {
namespace {

constexpr int kMostSteps = 20;           // 2 to 4 are usual
constexpr double kSettledShare = 1e-11;  // of the distance: 4e-9 mm at 400 mm

struct Normal {
  Matrix3 information = Matrix3::Zero();  // J' W J
  Vec3 gradient = Vec3::Zero();           // J' W r
  double chi2 = 0.0;
  PerSide<Vec2> residual_px{Vec2::Zero(), Vec2::Zero()};
};

/// The normal equations at a point in front of both cameras.
Normal normal_equations(const Rig& rig, const PerSide<MeasuredPixel>& seen, const PerSide<Matrix2>& weight,
                        const Vec3& point_in_rig) {
  Normal normal;
  for (const Side side : kBothSides) {
    const Isometry3& camera_from_rig = rig.camera_from_rig[side];
    const Vec3 point_in_camera = camera_from_rig * point_in_rig;
    const RawPixel predicted = distorted(
        rig.cameras[side], {point_in_camera.x() / point_in_camera.z(), point_in_camera.y() / point_in_camera.z()});
    const Vec2 residual{seen[side].at.u_px - predicted.u_px, seen[side].at.v_px - predicted.v_px};
    const Matrix23 jacobian =
        projection_jacobian_px_per_mm(rig.cameras[side], point_in_camera) * camera_from_rig.linear();
    const Eigen::Matrix<double, 3, 2> weighted = jacobian.transpose() * weight[side];
    normal.information += weighted * jacobian;
    normal.gradient += weighted * residual;
    normal.chi2 += residual.dot(weight[side] * residual);
    normal.residual_px[side] = residual;
  }
  return normal;
}

bool positive_definite(const Matrix2& m) { return m(0, 0) > 0.0 && m.determinant() > 0.0 && m.allFinite(); }

}  // namespace

Result<TriangulatedPoint> triangulated(const Rig& rig, const PerSide<MeasuredPixel>& seen, double min_angle_rad) {
  if (!positive_definite(seen.left.covariance_px2) || !positive_definite(seen.right.covariance_px2)) {
    return failure(ErrorCode::kDegenerate);
  }
  const Result<PerSide<Ray>> rays = rays_of(rig, {seen.left.at, seen.right.at});
  if (!rays) return tl::make_unexpected(rays.error());
  if (!(std::sin(angle_between_rad(*rays)) > std::sin(min_angle_rad))) return failure(ErrorCode::kRaysAlmostParallel);

  const PerSide<Matrix2> weight{seen.left.covariance_px2.inverse(), seen.right.covariance_px2.inverse()};
  Vec3 point = midpoint_in_rig_mm(*rays);
  for (int step = 0; step < kMostSteps; ++step) {
    if (!in_front_of_both(rig, point)) return failure(ErrorCode::kBehindCamera);
    const Normal normal = normal_equations(rig, seen, weight, point);
    const Matrix3 covariance = normal.information.inverse();
    const Vec3 move = covariance * normal.gradient;
    if (move.norm() <= kSettledShare * point.norm()) {
      return TriangulatedPoint{point, covariance, normal.chi2, normal.residual_px};
    }
    point += move;
  }
  return failure(ErrorCode::kNoConvergence);
}

Result<EpipolarError> epipolar_error(const Rig& rig, const PerSide<MeasuredPixel>& seen) {
  const Result<NormalizedPoint> left_at = undistorted(rig.cameras.left, seen.left.at);
  if (!left_at) return tl::make_unexpected(left_at.error());
  const Result<NormalizedPoint> right_at = undistorted(rig.cameras.right, seen.right.at);
  if (!right_at) return tl::make_unexpected(right_at.error());

  const Matrix3 essential = essential_matrix(rig);
  const Vec3 left{left_at->x, left_at->y, 1.0};
  const Vec3 right{right_at->x, right_at->y, 1.0};
  const Vec3 line_in_left = essential * right;
  const Vec3 line_in_right = essential.transpose() * left;
  // d(constraint)/d(raw pixel) = line' * inverse of the distortion's Jacobian.
  const Vec2 left_slope =
      distortion_jacobian_px(rig.cameras.left, *left_at).transpose().inverse() * line_in_left.head<2>();
  const Vec2 right_slope =
      distortion_jacobian_px(rig.cameras.right, *right_at).transpose().inverse() * line_in_right.head<2>();
  const double slope2 = left_slope.squaredNorm() + right_slope.squaredNorm();
  if (!(slope2 > 0.0)) return failure(ErrorCode::kDegenerate);
  const double spread =
      left_slope.dot(seen.left.covariance_px2 * left_slope) + right_slope.dot(seen.right.covariance_px2 * right_slope);
  return EpipolarError{left.dot(line_in_left) / std::sqrt(slope2), spread / slope2};
}

}  // namespace tripoint
