#include "bench/pose_error.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tripoint::bench {
namespace {

constexpr double kWrong_mm = 1.0;
constexpr double kWrong_rad = std::numbers::pi / 180.0;
constexpr double kNotNoise = 1e-6;

}  // namespace

PoseError pose_error(const TargetPose& measured, const Isometry3& output_from_target) {
  PoseError pose;
  pose.error.head<3>() = measured.position_in_output_mm - output_from_target.translation();
  if (measured.output_from_target) {
    const Eigen::AngleAxisd turn(*measured.output_from_target * output_from_target.linear().transpose());
    pose.error.tail<3>() = turn.angle() * turn.axis();
    pose.size = 6;
  }
  const Matrix6 spread = measured.noise + measured.shared;
  const auto error = pose.error.head(pose.size);
  pose.chi2 = error.dot(spread.topLeftCorner(pose.size, pose.size).ldlt().solve(error));
  return pose;
}

double tail_beyond(const PoseError& pose) {
  const double half = 0.5 * pose.chi2;
  if (pose.size == 6) return std::exp(-half) * (1.0 + half + 0.5 * half * half);
  return std::erfc(std::sqrt(half)) + 2.0 * std::sqrt(half / std::numbers::pi) * std::exp(-half);
}

bool is_wrong(const PoseError& pose) {
  const bool near = pose.position_mm() <= kWrong_mm && pose.angle_rad() <= kWrong_rad;
  const bool noise = pose.chi2 >= 0.0 && tail_beyond(pose) >= kNotNoise;  // no covariance at all is no excuse
  return !near && !noise;
}

}  // namespace tripoint::bench
