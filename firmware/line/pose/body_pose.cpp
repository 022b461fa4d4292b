#include "line/pose/body_pose.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/rigid_fit.h"
#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr double kDifference_mm = 1e-3;  // of a central difference: second order below 1e-9 at 50 mm

using Matrix63 = Eigen::Matrix<double, 6, 3>;
/// How the pose moves with each of its points.
using Gains = FixedVector<Matrix63, kMaxTargetPoints>;

struct Estimate {
  Isometry3 rig_from_target = Isometry3::Identity();
  Matrix6 noise = Matrix6::Zero();
  Gains gains;
};

double sigma_of(const TargetPoint& point) { return point.uncertainty_mm / 2.0; }

Isometry3 by_three_points(const std::array<Vec3, 3>& seen, std::span<const LocatedPoint> points) {
  const Isometry3 made =
      three_point_frame(points[0].of.in_target_mm, points[1].of.in_target_mm, points[2].of.in_target_mm);
  return three_point_frame(seen[0], seen[1], seen[2]) * made.inverse();
}

std::array<Vec3, 3> first_three(std::span<const LocatedPoint> points) {
  return {points[0].place.in_rig_mm, points[1].place.in_rig_mm, points[2].place.in_rig_mm};
}

PoseParameters step_between(const Isometry3& from, const Isometry3& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  PoseParameters step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

/// The frame of the first three points; what follows is by central differences.
Estimate by_paper(std::span<const LocatedPoint> points) {
  Estimate estimate;
  const std::array<Vec3, 3> seen = first_three(points);
  estimate.rig_from_target = by_three_points(seen, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Matrix63 gain = Matrix63::Zero();
    for (int axis = 0; i < 3 && axis < 3; ++axis) {
      std::array<Vec3, 3> before = seen;
      std::array<Vec3, 3> after = seen;
      before[i][axis] -= kDifference_mm;
      after[i][axis] += kDifference_mm;
      gain.col(axis) =
          step_between(by_three_points(before, points), by_three_points(after, points)) / (2.0 * kDifference_mm);
    }
    const Matrix3 spread = points[i].place.covariance_mm2 + std::pow(sigma_of(points[i].of), 2) * Matrix3::Identity();
    estimate.noise += gain * spread * gain.transpose();
    estimate.gains.push_back(gain);
  }
  return estimate;
}

/// Weighted least squares in the pictures is, to first order, that of the places by their covariances.
Gains gains_of_fit(std::span<const LocatedPoint> points, const RigidFit& fit) {
  Gains gains;
  for (const LocatedPoint& point : points) {
    const Matrix3 spread = point.place.covariance_mm2 + std::pow(sigma_of(point.of), 2) * Matrix3::Identity();
    Eigen::Matrix<double, 3, 6> slope;
    slope << Matrix3::Identity(), -cross_matrix(fit.rig_from_body.linear() * point.of.in_target_mm);
    gains.push_back(fit.covariance * slope.transpose() * spread.inverse());
  }
  return gains;
}

Result<Estimate> by_fit(std::span<const LocatedPoint> points, const LineModel& model) {
  FixedVector<BodyPoint, kMaxTargetPoints> body;
  for (const LocatedPoint& point : points) body.push_back({point.of.in_target_mm, sigma_of(point.of), point.pixels});
  const Isometry3 start = by_three_points(first_three(points), points);
  const Result<RigidFit> fit = rigid_fit(model.rig, {body.begin(), body.size()}, start);
  if (!fit) return tl::make_unexpected(fit.error());
  return Estimate{fit->rig_from_body, fit->covariance, gains_of_fit(points, *fit)};
}

/// What all points share: to first order the sum over the points of what moves each.
template <int kColumns, typename Moved>
Eigen::Matrix<double, 6, kColumns> moved_together(std::span<const LocatedPoint> points, const Gains& gains,
                                                  Moved moved) {
  Eigen::Matrix<double, 6, kColumns> sum = Eigen::Matrix<double, 6, kColumns>::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += gains[i].lazyProduct(moved(points[i]));
  return sum;
}

Matrix6 turned(const Matrix6& covariance, const Matrix3& rotation) {
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = rotation;
  turn.bottomRightCorner<3, 3>() = rotation;
  return turn * covariance * turn.transpose();
}

std::optional<double> cost_of_skew_mm(std::span<const LocatedPoint> points, const Gains& gains) {
  for (const LocatedPoint& point : points) {
    if (!point.moved_by_skew_mm) return std::nullopt;
  }
  return moved_together<1>(points, gains, [](const LocatedPoint& point) { return *point.moved_by_skew_mm; })
      .template head<3>()
      .norm();
}

}  // namespace

Result<BodyPose> pose_of_body(std::span<const LocatedPoint> points, const LineModel& model) {
  const Result<Estimate> estimate =
      model.method == Method::kPaper ? Result<Estimate>(by_paper(points)) : by_fit(points, model);
  if (!estimate) return tl::make_unexpected(estimate.error());
  const auto by_calibration =
      moved_together<24>(points, estimate->gains, [](const LocatedPoint& point) { return point.place_by_calibration; });
  const auto by_clocks =
      moved_together<4>(points, estimate->gains, [](const LocatedPoint& point) { return point.moved_by_clocks_mm; });
  const Matrix6 timing = by_clocks * by_clocks.transpose();

  BodyPose pose;
  const Isometry3 output_from_target = model.output_from_rig * estimate->rig_from_target;
  const Matrix3 rotation = model.output_from_rig.linear();
  pose.in_output.position_in_output_mm = output_from_target.translation();
  pose.in_output.output_from_target = output_from_target.linear();
  pose.in_output.noise = turned(estimate->noise + timing, rotation);
  const Eigen::Matrix<double, 6, 24> spread = by_calibration.lazyProduct(model.covariance);
  pose.in_output.shared = turned(spread.lazyProduct(by_calibration.transpose()), rotation);
  pose.timing_sigma_mm = std::sqrt(timing.topLeftCorner<3, 3>().trace());
  pose.uncorrected_cost_mm = cost_of_skew_mm(points, estimate->gains);
  return pose;
}

}  // namespace tripoint
