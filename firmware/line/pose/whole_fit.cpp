#include "line/pose/whole_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>

#include "geometry/rigid_fit.h"
#include "geometry/triangulation.h"
#include "line/pose/pixel_rows.h"
#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr int kMostSteps = 300;         // 3 to 8 are usual; towards a wrong tilt, down a narrow valley, 200 were seen
constexpr double kSettled = 1e-7;       // mm, and rad times the distance, over the distance: chi-square stands to 1e-6
constexpr double kLeastDamping = 1e-3;  // of the information's diagonal
constexpr double kDampingRatio = 10.0;
constexpr double kSlack = 1e-6;  // chi-square is not known better than that

constexpr double kRareNormal = 3.0902;  // deviations that a normal value exceeds once in 1,000 times

constexpr int kCalibration = 24;
constexpr int kShared = kCalibration + 4;  // and two directions of the clocks in each picture

using Points = std::span<const LocatedPoint>;
using RowsByShared = Eigen::Matrix<double, Eigen::Dynamic, kShared, 0, kMostRows, kShared>;
using SharedByPose = Eigen::Matrix<double, kShared, 6>;
using SharedVector = Eigen::Matrix<double, kShared, 1>;
using SharedMatrix = Eigen::Matrix<double, kShared, kShared>;

/// root root' = covariance, which may leave some parameters without an error.
RigCovariance root_of(const RigCovariance& covariance) {
  const Eigen::LDLT<RigCovariance> factor(covariance);
  const RigParameters deviations = factor.vectorD().cwiseMax(0.0).cwiseSqrt();
  const RigCovariance lower = RigCovariance(factor.matrixL()) * deviations.asDiagonal();
  return factor.transpositionsP().transpose() * lower;
}

/// One tag's corners, or one centre: what they err by is white when divided by the root of their own covariance.
struct Part {
  Points points;
  Eigen::LLT<PixelCovariance> root;
  RowsByShared by_shared;  ///< whitened pixels by what all points share, each of unit variance
};

/// Constant, whatever the pose: to first order the covariance is that at the places where the points were seen.
struct Weights {
  FixedVector<Part, kMaxTargetPoints> parts;
  Eigen::LLT<SharedMatrix> shared;  ///< information about what all points share, what is known beforehand included
};

PixelCovariance own_covariance_px2(Points part, const LineModel& model) {
  PixelCovariance covariance = spots_covariance_px2(part);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Eigen::Matrix<double, kPixels, 3> by_place = pixels_by_place(model.rig, part[i].place.in_rig_mm);
    const double sigma_mm = part[i].of.uncertainty_mm / 2.0;
    covariance.block<kPixels, kPixels>(row_of(i), row_of(i)) += sigma_mm * sigma_mm * by_place * by_place.transpose();
  }
  return covariance;
}

/// @param calibration_root  nothing: the calibration does not err
RowsByShared by_shared(Points points, const LineModel& model, const std::optional<RigCovariance>& calibration_root) {
  RowsByShared by = RowsByShared::Zero(row_of(points.size()), kShared);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (calibration_root) {
      by.block<kPixels, kCalibration>(row_of(i), 0) =
          pixels_by_calibration(model.calibration, points[i].place.in_rig_mm).lazyProduct(*calibration_root);
    }
    for (const Side side : kBothSides) {
      by.block<2, 2>(row_of(i) + first_row(side), kCalibration + first_row(side)) = points[i].clocks_root_px[side];
    }
  }
  return by;
}

/// @return kDegenerate for a covariance that is none
Result<Weights> weights_of(Points points, const LineModel& model) {
  std::optional<RigCovariance> calibration_root;
  if (!model.covariance.isZero(0.0)) calibration_root = root_of(model.covariance);
  Weights weights;
  SharedMatrix information = SharedMatrix::Identity();
  for (std::size_t first = 0; first < points.size();) {
    const Points own = part_from(points, first);
    const PixelCovariance covariance_px2 = own_covariance_px2(own, model);
    Part part{own, Eigen::LLT<PixelCovariance>(covariance_px2), by_shared(own, model, calibration_root)};
    if (part.root.info() != Eigen::Success || !covariance_px2.allFinite()) return failure(ErrorCode::kDegenerate);
    part.root.matrixL().solveInPlace(part.by_shared);
    information += part.by_shared.transpose().lazyProduct(part.by_shared);
    weights.parts.push_back(part);
    first += own.size();
  }
  weights.shared.compute(information);
  return weights;
}

/// At one pose, with what all points share at its best.
struct Normal {
  Matrix6 information = Matrix6::Zero();
  PoseParameters gradient = PoseParameters::Zero();
  double chi2 = 0.0;
};

/// @return kBehindCamera
Result<Normal> normal_at(const Isometry3& pose, const Weights& weights, const Rig& rig) {
  Normal normal;
  SharedVector shared = SharedVector::Zero();
  SharedByPose shared_by_pose = SharedByPose::Zero();
  for (const Part& part : weights.parts) {
    std::optional<PixelOffset> offset = pixel_offset(pose, part.points, rig);
    if (!offset) return failure(ErrorCode::kBehindCamera);
    part.root.matrixL().solveInPlace(offset->px);
    part.root.matrixL().solveInPlace(offset->by_pose);
    normal.information += offset->by_pose.transpose().lazyProduct(offset->by_pose);
    normal.gradient += offset->by_pose.transpose().lazyProduct(offset->px);
    normal.chi2 += offset->px.squaredNorm();
    shared += part.by_shared.transpose().lazyProduct(offset->px);
    shared_by_pose += part.by_shared.transpose().lazyProduct(offset->by_pose);
  }
  const SharedVector best = weights.shared.solve(shared);
  normal.information -= shared_by_pose.transpose().lazyProduct(weights.shared.solve(shared_by_pose));
  normal.gradient -= shared_by_pose.transpose().lazyProduct(best);
  normal.chi2 -= shared.dot(best);
  return normal;
}

/// Nothing when the points do not say where to go.
std::optional<PoseParameters> step_from(const Normal& normal, double damping) {
  Matrix6 damped = normal.information;
  damped.diagonal() *= 1.0 + damping;
  const Eigen::LLT<Matrix6> factor(damped);
  const PoseParameters step = factor.solve(normal.gradient);
  if (factor.info() != Eigen::Success || !step.allFinite()) return std::nullopt;
  return step;
}

bool settled(const PoseParameters& step, double distance_mm) {
  return step.head<3>().norm() + distance_mm * step.tail<3>().norm() <= kSettled * (1.0 + distance_mm);
}

}  // namespace

Result<WholeFit> whole_fit(Points points, const LineModel& model, const Isometry3& start) {
  const Result<Weights> weights = weights_of(points, model);
  if (!weights) return tl::make_unexpected(weights.error());
  Isometry3 pose = start;
  Result<Normal> here = normal_at(pose, *weights, model.rig);
  double damping = 0.0;
  for (int tried = 0; tried < kMostSteps && here; ++tried) {
    const std::optional<PoseParameters> step = step_from(*here, 0.0);
    if (!step) return failure(ErrorCode::kDegenerate);
    if (settled(*step, pose.translation().norm())) {
      return WholeFit{moved(pose, *step), here->chi2 - here->gradient.dot(*step)};
    }
    const Isometry3 next = moved(pose, damping > 0.0 ? step_from(*here, damping).value_or(*step) : *step);
    const Result<Normal> there = normal_at(next, *weights, model.rig);
    if (there && there->chi2 <= here->chi2 + kSlack) {
      pose = next;
      here = there;
      damping = damping > kLeastDamping ? damping / kDampingRatio : 0.0;
    } else {
      damping = std::max(kDampingRatio * damping, kLeastDamping);
    }
  }
  if (!here) return tl::make_unexpected(here.error());
  return failure(ErrorCode::kNoConvergence);
}

Result<double> whole_chi2(Points points, const LineModel& model, const Isometry3& rig_from_target) {
  const Result<Weights> weights = weights_of(points, model);
  if (!weights) return tl::make_unexpected(weights.error());
  return normal_at(rig_from_target, *weights, model.rig).map([](const Normal& normal) { return normal.chi2; });
}

double most_chi2(std::size_t points) {
  const double freedom = 4.0 * static_cast<double>(points) - 6.0;
  const double spread = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - spread + kRareNormal * std::sqrt(spread), 3);
}

}  // namespace tripoint
