#include "line/pose/body_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/rigid_fit.h"
#include "line/pose/output_frame.h"
#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr double kMostOff = 64.0;        // chi-square of one point: 8 deviations of its place and the pose's together
constexpr double kDifference_mm = 1e-3;  // of a central difference: second order below 1e-9 at 50 mm

using Matrix63 = Eigen::Matrix<double, 6, 3>;
/// How the pose moves with each of its points.
using Gains = FixedVector<Matrix63, kMaxImagePoints>;

struct Estimate {
  Isometry3 rig_from_target = Isometry3::Identity();
  Matrix6 noise = Matrix6::Zero();
  Gains gains;
};

double sigma_of(const TargetPoint& point) { return point.uncertainty_mm / 2.0; }

/// The points of the widest triangle: it says best how the target is turned.
std::array<std::size_t, 3> widest_of(std::span<const LocatedPoint> points) {
  FixedVector<Vec3, kMaxImagePoints> made_mm;
  for (const LocatedPoint& point : points) made_mm.push_back(point.of.in_target_mm);
  return widest_triangle({made_mm.begin(), made_mm.size()});
}

struct Triangle {
  std::array<std::size_t, 3> index{0, 1, 2};
  Isometry3 target_from_frame = Isometry3::Identity();
  std::array<Vec3, 3> seen_mm;
};

Triangle triangle_of(std::span<const LocatedPoint> points) {
  const std::array<std::size_t, 3> index = widest_of(points);
  const auto made = [&](std::size_t k) { return points[index[k]].of.in_target_mm; };
  const auto seen = [&](std::size_t k) { return points[index[k]].place.in_rig_mm; };
  return {index, three_point_frame(made(0), made(1), made(2)), {seen(0), seen(1), seen(2)}};
}

Isometry3 by_three_points(const Triangle& triangle, const std::array<Vec3, 3>& seen_mm) {
  return three_point_frame(seen_mm[0], seen_mm[1], seen_mm[2]) * triangle.target_from_frame.inverse();
}

PoseParameters step_between(const Isometry3& from, const Isometry3& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  PoseParameters step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

/// The frame of three points; how it follows them is by central differences.
Estimate by_paper(std::span<const LocatedPoint> points) {
  Estimate estimate;
  const Triangle triangle = triangle_of(points);
  estimate.rig_from_target = by_three_points(triangle, triangle.seen_mm);
  for (std::size_t i = 0; i < points.size(); ++i) estimate.gains.push_back(Matrix63::Zero());
  for (std::size_t k = 0; k < 3; ++k) {
    const LocatedPoint& point = points[triangle.index[k]];
    Matrix63& gain = estimate.gains[triangle.index[k]];
    for (int axis = 0; axis < 3; ++axis) {
      std::array<Vec3, 3> before = triangle.seen_mm;
      std::array<Vec3, 3> after = triangle.seen_mm;
      before[k][axis] -= kDifference_mm;
      after[k][axis] += kDifference_mm;
      gain.col(axis) =
          step_between(by_three_points(triangle, before), by_three_points(triangle, after)) / (2.0 * kDifference_mm);
    }
    const Matrix3 spread = point.place.covariance_mm2 + std::pow(sigma_of(point.of), 2) * Matrix3::Identity();
    estimate.noise += gain * spread * gain.transpose();
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

/// What neighbouring corners err by together, which the fit takes for errors of each.
Matrix6 noise_of_shared_edges(std::span<const LocatedPoint> points, const Gains& gains) {
  Matrix6 noise = Matrix6::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].next) continue;
    const std::size_t next = *points[i].next;
    for (const Side side : kBothSides) {
      const Eigen::Matrix<double, 6, 2> by_this = gains[i] * points[i].by_pixel[side];
      const Eigen::Matrix<double, 6, 2> by_next = gains[next] * points[next].by_pixel[side];
      const Matrix6 together = by_this * points[i].shared_with_next_px2[side] * by_next.transpose();
      noise += together + together.transpose();
    }
  }
  return noise;
}

Result<Estimate> by_fit(std::span<const LocatedPoint> points, const LineModel& model, const Isometry3& start) {
  FixedVector<BodyPoint, kMaxImagePoints> body;
  for (const LocatedPoint& point : points) body.push_back({point.of.in_target_mm, sigma_of(point.of), point.pixels});
  const Result<RigidFit> fit = rigid_fit(model.rig, {body.begin(), body.size()}, start);
  if (!fit) return tl::make_unexpected(fit.error());
  const Gains gains = gains_of_fit(points, *fit);
  return Estimate{fit->rig_from_body, fit->covariance + noise_of_shared_edges(points, gains), gains};
}

/// What all points share: to first order the sum over the points of what moves each.
template <int kColumns, typename Moved>
Eigen::Matrix<double, 6, kColumns> moved_together(std::span<const LocatedPoint> points, const Gains& gains,
                                                  Moved moved) {
  Eigen::Matrix<double, 6, kColumns> sum = Eigen::Matrix<double, 6, kColumns>::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += gains[i].lazyProduct(moved(points[i]));
  return sum;
}

/// Whether every point of the target, put where the pose says, lies where it was seen: no fit that has gone astray.
bool holds(const Estimate& estimate, std::span<const LocatedPoint> points, const LineModel& model) {
  return std::all_of(points.begin(), points.end(), [&](const LocatedPoint& point) {
    const Vec3 error_mm = point.place.in_rig_mm - estimate.rig_from_target * point.of.in_target_mm;
    Eigen::Matrix<double, 3, 6> slope;
    slope << Matrix3::Identity(), -cross_matrix(estimate.rig_from_target.linear() * point.of.in_target_mm);
    const Eigen::Matrix<double, 3, 24> shared = point.place_by_calibration.lazyProduct(model.covariance);
    const Matrix3 spread = point.place.covariance_mm2 + std::pow(sigma_of(point.of), 2) * Matrix3::Identity() +
                           shared.lazyProduct(point.place_by_calibration.transpose()) +
                           slope * estimate.noise * slope.transpose();
    return error_mm.dot(Eigen::LLT<Matrix3>(spread).solve(error_mm)) <= kMostOff;
  });
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

Isometry3 pose_of_widest_triangle(std::span<const LocatedPoint> points) {
  const Triangle triangle = triangle_of(points);
  return by_three_points(triangle, triangle.seen_mm);
}

Result<BodyPose> pose_of_body(std::span<const LocatedPoint> points, const LineModel& model) {
  return pose_of_body(points, model, pose_of_widest_triangle(points));
}

Result<BodyPose> pose_of_body(std::span<const LocatedPoint> points, const LineModel& model, const Isometry3& start) {
  const Result<Estimate> estimate =
      model.method == Method::kPaper ? Result<Estimate>(by_paper(points)) : by_fit(points, model, start);
  if (!estimate) return tl::make_unexpected(estimate.error());
  if (!holds(*estimate, points, model)) return failure(ErrorCode::kNoConvergence);
  const auto by_calibration = pose_in_output_by(
      moved_together<24>(points, estimate->gains, [](const LocatedPoint& point) { return point.place_by_calibration; }),
      estimate->rig_from_target.translation(), model);
  const auto by_clocks =
      moved_together<4>(points, estimate->gains, [](const LocatedPoint& point) { return point.moved_by_clocks_mm; });
  const Matrix6 timing = by_clocks * by_clocks.transpose();

  BodyPose pose;
  pose.rig_from_target = estimate->rig_from_target;
  const Isometry3 output_from_target = model.output_from_rig * estimate->rig_from_target;
  const Matrix3 rotation = model.output_from_rig.linear();
  pose.in_output.position_in_output_mm = output_from_target.translation();
  pose.in_output.output_from_target = output_from_target.linear();
  pose.in_output.noise = turned(estimate->noise + timing, rotation);
  const Eigen::Matrix<double, 6, 24> spread = by_calibration.lazyProduct(model.covariance);
  pose.in_output.shared = spread.lazyProduct(by_calibration.transpose());
  pose.timing_sigma_mm = std::sqrt(timing.topLeftCorner<3, 3>().trace());
  pose.uncorrected_cost_mm = cost_of_skew_mm(points, estimate->gains);
  return pose;
}

}  // namespace tripoint
