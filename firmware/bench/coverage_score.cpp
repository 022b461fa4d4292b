#include "bench/coverage_score.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/rigid_fit.h"
#include "line/gate/gate.h"
#include "line/match/match.h"
#include "line/pose/pose.h"
#include "sim/default_rig.h"
#include "sim/target_view.h"

namespace tripoint::bench {
namespace {

// 95 % of chi-square with three and with six degrees of freedom.
constexpr double kMostOfPosition = 7.815;
constexpr double kMostOfPose = 12.592;

const std::array<Vec3, 1> kOne{Vec3(0.0, 0.0, 0.0)};
const std::array<Vec3, 3> kTriangle{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};
const std::array<Vec3, 4> kFour{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0),
                                Vec3(50.0, 20.0, 40.0)};
const std::array<CoveredTarget, 3> kTargets{
    {{"one LED", "one", kOne}, {"three LEDs", "three", kTriangle}, {"four LEDs", "four", kFour}}};

/// Position, mm, and rotation vector, rad, about the axes of the output frame.
PoseParameters error_of(const TargetPose& measured, const Isometry3& truth) {
  PoseParameters error = PoseParameters::Zero();
  error.head<3>() = measured.position_in_output_mm - truth.translation();
  if (measured.output_from_target) {
    const Eigen::AngleAxisd turn(*measured.output_from_target * truth.linear().transpose());
    error.tail<3>() = turn.angle() * turn.axis();
  }
  return error;
}

struct Sums {
  int inside = 0;
  int axes = 0;
  int axes_inside = 0;
  double squares_mm2 = 0.0;
  double squares_rad2 = 0.0;
};

void add(Sums& sums, const TargetPose& pose, const Isometry3& truth) {
  const PoseParameters error = error_of(pose, truth);
  const Matrix6 spread = pose.noise + pose.shared;
  const Eigen::Index size = pose.output_from_target ? 6 : 3;
  const double chi2 = error.head(size).dot(spread.topLeftCorner(size, size).ldlt().solve(error.head(size)));
  sums.inside += chi2 <= (size == 6 ? kMostOfPose : kMostOfPosition) ? 1 : 0;
  for (Eigen::Index axis = 0; axis < size; ++axis) {
    ++sums.axes;
    sums.axes_inside += error[axis] * error[axis] <= 4.0 * spread(axis, axis) ? 1 : 0;
  }
  sums.squares_mm2 += error.head<3>().squaredNorm();
  sums.squares_rad2 += error.tail<3>().squaredNorm();
}

}  // namespace

std::span<const CoveredTarget> covered_targets() { return kTargets; }

CoverageScore coverage_score(std::span<const Vec3> leds_mm, const ErrorSources& sources, std::uint64_t first_seed,
                             int views) {
  const StereoCalibration truth = default_rig();
  const Rig rig = rig_of(truth).value();
  const ViewSettings alone{.sigma_px = sources.spot_px,
                           .most_others = 0,
                           .hidden_share = 0.0,
                           .mirror_share = 0.0,
                           .middle_mm = {0.0, 0.0, 400.0},
                           .half_mm = {150.0, 150.0, 100.0}};
  const ErringUnits units(truth, sources);
  CoverageScore score;
  Sums sums;
  for (; score.views < views; ++score.views) {
    const auto seed = first_seed + static_cast<std::uint64_t>(score.views);
    std::mt19937_64 random(~seed);
    const LineModel model = units.model(leds_mm, random);
    const TargetView view = target_view(rig, units.target(leds_mm, random), alone, seed);
    const Aligned seen = as_seen(view, sources.spot_px);
    const Pairs pairs = match(seen, model);
    const Measurement measured = gate(seen, pairs, pose_of_target(seen, pairs, model), model);
    if (!measured.pose) continue;
    ++score.poses;
    add(sums, *measured.pose, view.rig_from_target);
  }
  if (score.poses == 0) return score;
  score.inside_share = 1.0 * sums.inside / score.poses;
  score.axes_inside_share = 1.0 * sums.axes_inside / sums.axes;
  score.position_rms_mm = std::sqrt(sums.squares_mm2 / score.poses);
  score.orientation_rms_deg = std::sqrt(sums.squares_rad2 / score.poses) * 180.0 / std::numbers::pi;
  return score;
}

}  // namespace tripoint::bench
