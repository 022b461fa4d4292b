#include "geometry/rigid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <optional>

namespace tripoint {
namespace {

constexpr int kMostSteps = 20;               // 3 to 5 are usual
constexpr double kSettled = 1e-9;            // mm, and rad times the distance
constexpr double kLeastConditioned = 1e-12;  // of the information, its units balanced

using Vec4 = Eigen::Matrix<double, 4, 1>;
using Matrix4 = Eigen::Matrix<double, 4, 4>;
using Matrix43 = Eigen::Matrix<double, 4, 3>;
using Matrix46 = Eigen::Matrix<double, 4, 6>;

/// One point's four pixel coordinates at a place in the rig.
struct Reprojection {
  Vec4 residual_px = Vec4::Zero();
  Matrix43 jacobian_px_per_mm = Matrix43::Zero();
};

std::optional<Reprojection> reprojection(const Rig& rig, const PerSide<MeasuredPixel>& seen, const Vec3& point_in_rig) {
  Reprojection both;
  for (const Side side : kBothSides) {
    const Isometry3& camera_from_rig = rig.camera_from_rig[side];
    const Vec3 in_camera = camera_from_rig * point_in_rig;
    const Result<RawPixel> predicted = projected(rig.cameras[side], in_camera);
    if (!predicted) return std::nullopt;
    const int row = side == Side::kLeft ? 0 : 2;
    both.residual_px.segment<2>(row) << seen[side].at.u_px - predicted->u_px, seen[side].at.v_px - predicted->v_px;
    both.jacobian_px_per_mm.middleRows<2>(row) =
        projection_jacobian_px_per_mm(rig.cameras[side], in_camera) * camera_from_rig.linear();
  }
  return both;
}

struct Normal {
  Matrix6 information = Matrix6::Zero();
  PoseParameters gradient = PoseParameters::Zero();
  double chi2 = 0.0;
};

/// @return kBehindCamera, or kDegenerate for a covariance that is none
Result<Normal> normal_equations(const Rig& rig, std::span<const BodyPoint> points, const Isometry3& pose) {
  Normal normal;
  for (const BodyPoint& point : points) {
    const Vec3 arm_mm = pose.linear() * point.in_body_mm;
    const std::optional<Reprojection> at = reprojection(rig, point.seen, pose.translation() + arm_mm);
    if (!at) return failure(ErrorCode::kBehindCamera);
    Matrix4 covariance = point.sigma_mm * point.sigma_mm * at->jacobian_px_per_mm * at->jacobian_px_per_mm.transpose();
    covariance.topLeftCorner<2, 2>() += point.seen.left.covariance_px2;
    covariance.bottomRightCorner<2, 2>() += point.seen.right.covariance_px2;
    const Eigen::LLT<Matrix4> factor(covariance);
    if (factor.info() != Eigen::Success || !covariance.allFinite()) return failure(ErrorCode::kDegenerate);
    Matrix46 jacobian;
    jacobian << at->jacobian_px_per_mm, -at->jacobian_px_per_mm * cross_matrix(arm_mm);
    const Matrix46 whitened = factor.matrixL().solve(jacobian);
    const Vec4 residual = factor.matrixL().solve(at->residual_px);
    normal.information += whitened.transpose() * whitened;
    normal.gradient += whitened.transpose() * residual;
    normal.chi2 += residual.squaredNorm();
  }
  return normal;
}

/// Whether every direction of the pose is seen: by the smallest eigenvalue, each parameter in its own unit.
bool determined(const Matrix6& information) {
  const PoseParameters unit = information.diagonal().cwiseSqrt().cwiseInverse();
  if (!unit.allFinite()) return false;
  const Matrix6 balanced = unit.asDiagonal() * information * unit.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix6>(balanced, Eigen::EigenvaluesOnly).eigenvalues()(0) > kLeastConditioned;
}

}  // namespace

std::array<std::size_t, 3> widest_triangle(std::span<const Vec3> points) {
  std::array<std::size_t, 3> widest{0, 1, 2};
  double largest = 0.0;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        const double area = (points[b] - points[a]).cross(points[c] - points[a]).norm();
        if (area <= largest) continue;
        largest = area;
        widest = {a, b, c};
      }
    }
  }
  return widest;
}

Isometry3 three_point_frame(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  Isometry3 frame = Isometry3::Identity();
  const Vec3 middle = 0.5 * (p1 + p2);
  const Vec3 x = (p2 - p1).normalized();
  const Vec3 y = (middle - p3).cross(x).normalized();
  frame.linear() << x, y, x.cross(y);
  frame.translation() = middle;
  return frame;
}

Isometry3 moved(const Isometry3& pose, const PoseParameters& step) {
  const Vec3 turn_rad = step.tail<3>();
  const double angle_rad = turn_rad.norm();
  Isometry3 there = pose;
  if (angle_rad > 0.0) there.linear() = Eigen::AngleAxisd(angle_rad, turn_rad / angle_rad) * pose.linear();
  there.translation() += step.head<3>();
  return there;
}

Result<RigidFit> rigid_fit(const Rig& rig, std::span<const BodyPoint> points, const Isometry3& start) {
  RigidFit fit{start, Matrix6::Zero(), 0.0};
  for (int step = 0; step < kMostSteps; ++step) {
    const Result<Normal> normal = normal_equations(rig, points, fit.rig_from_body);
    if (!normal) return tl::make_unexpected(normal.error());
    if (!determined(normal->information)) return failure(ErrorCode::kDegenerate);
    const Eigen::LLT<Matrix6> factor(normal->information);
    const PoseParameters move = factor.solve(normal->gradient);
    const double distance_mm = fit.rig_from_body.translation().norm();
    if (move.head<3>().norm() + distance_mm * move.tail<3>().norm() <= kSettled * (1.0 + distance_mm)) {
      fit.covariance = factor.solve(Matrix6::Identity());
      fit.chi2 = normal->chi2;
      return fit;
    }
    fit.rig_from_body = moved(fit.rig_from_body, move);
  }
  return failure(ErrorCode::kNoConvergence);
}

}  // namespace tripoint
