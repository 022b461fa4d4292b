#include "line/monitor/turn_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/rigid_fit.h"
#include "line/monitor/pair_evidence.h"
#include "line/pose/timing_part.h"
#include "values/fixed_vector.h"

namespace tripoint {
namespace {

constexpr double kUnstatedTurn_rad = 1e-4;  // standard deviation, of a calibration that does not state its own
constexpr double kTurnStep_rad = 1e-5;
constexpr double kMostTiming = 9.0;   // variance of the clocks' part over that of a spot
constexpr double kClockShare = 1e-3;  // of a standard deviation, for differences
constexpr int kRefinements = 2;       // of the pose that three points give

using ByClocks = Eigen::Matrix<double, 4, 4>;

/// A point of the target where it was seen: a place and an epipolar distance, uncorrelated to first order.
struct WatchedPoint {
  Vec3 in_target_mm = Vec3::Zero();
  Vec3 in_rig_mm = Vec3::Zero();
  Matrix3 place_weight = Matrix3::Identity();  ///< inverse covariance, from the image points alone
  double epipolar_px = 0.0;
  double epipolar_weight = 1.0;
  Eigen::Matrix<double, 3, 24> place_by_calibration;
  RigParameters epipolar_by_calibration;
  Matrix3 place_by_turn;
  Vec3 epipolar_by_turn;
  ByClocks by_clocks;
};
using WatchedPoints = FixedVector<WatchedPoint, kMaxTargetPoints>;

bool timed_well(const AlignedPoint& point) {
  return point.timing_px2.trace() <= kMostTiming * point.seen.covariance_px2.trace();
}

/// How place (three rows) and epipolar distance move with one standard deviation of the clocks.
ByClocks moved_by_clocks(const Pair& pair, const PerSide<MeasuredPixel>& pixels, const TriangulatedPoint& place,
                         const Rig& rig) {
  ByClocks moved = ByClocks::Zero();
  for (const Side side : kBothSides) {
    const AlignedPoint& image = pair.points[side];
    const Matrix2 root_px = timing_root_px(image.timing_px2, image.velocity_px_per_s);
    const int first = side == Side::kLeft ? 0 : 2;
    moved.block<3, 2>(0, first) = pixel_gain_mm_per_px(rig, place, pixels, side) * root_px;
    for (int column = 0; column < 2; ++column) {
      const auto distance_px = [&](double share) {
        PerSide<MeasuredPixel> shifted = pixels;
        shifted[side].at.u_px += share * root_px(0, column);
        shifted[side].at.v_px += share * root_px(1, column);
        const Result<EpipolarError> error = epipolar_error(rig, shifted);
        return error ? error->distance_px : 0.0;
      };
      moved(3, first + column) = (distance_px(kClockShare) - distance_px(-kClockShare)) / (2.0 * kClockShare);
    }
  }
  return moved;
}

std::optional<WatchedPoint> watched(const Pair& pair, const Vec3& in_target_mm, const LineModel& model,
                                    const Eigen::Matrix<double, 6, 3>& by_turn) {
  if (!timed_well(pair.points.left) || !timed_well(pair.points.right)) return std::nullopt;
  const std::optional<PairEvidence> seen = pair_evidence(pair, model);
  if (!seen) return std::nullopt;
  return WatchedPoint{in_target_mm,
                      seen->place.in_rig_mm,
                      seen->place.covariance_mm2.inverse(),
                      seen->epipolar.distance_px,
                      1.0 / seen->epipolar.noise_px2,
                      seen->place_by_calibration,
                      seen->epipolar_by_calibration,
                      seen->place_by_calibration.rightCols<6>() * by_turn,
                      by_turn.transpose() * seen->epipolar_by_calibration.tail<6>(),
                      moved_by_clocks(pair, seen->pixels, seen->place, model.rig)};
}

/// The pose of three points, which the eliminated pose is linear around.
Isometry3 start_of(const WatchedPoints& points) {
  FixedVector<Vec3, kMaxTargetPoints> made_mm;
  for (const WatchedPoint& point : points) made_mm.push_back(point.in_target_mm);
  const auto [a, b, c] = widest_triangle({made_mm.begin(), made_mm.size()});
  return three_point_frame(points[a].in_rig_mm, points[b].in_rig_mm, points[c].in_rig_mm) *
         three_point_frame(made_mm[a], made_mm[b], made_mm[c]).inverse();
}

/// Normal equations around a pose: of the pose itself, of it with the turn's columns, and of those alone.
struct NormalEquations {
  Matrix6 pose = Matrix6::Zero();
  Eigen::Matrix<double, 6, TurnEquations::ColsAtCompileTime> crossed =
      Eigen::Matrix<double, 6, TurnEquations::ColsAtCompileTime>::Zero();
  TurnEquations turn = TurnEquations::Zero();
};

NormalEquations around(const Isometry3& pose, const WatchedPoints& points) {
  NormalEquations sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WatchedPoint& point = points[i];
    const Vec3 arm_mm = pose.linear() * point.in_target_mm;
    Eigen::Matrix<double, 3, 6> place_by_pose;
    place_by_pose << Matrix3::Identity(), -cross_matrix(arm_mm);
    Eigen::Matrix<double, 3, TurnEquations::ColsAtCompileTime> place = decltype(place)::Zero();
    place.middleCols<3>(kTurnColumn) = point.place_by_turn;
    place.middleCols<24>(kCalibrationColumn) = point.place_by_calibration;
    place.middleCols<4>(kClockColumn) = point.by_clocks.topRows<3>();
    place.middleCols<3>(kTargetColumn + 3 * static_cast<Eigen::Index>(i)) = -pose.linear();
    place.col(kSeenColumn) = point.in_rig_mm - pose.translation() - arm_mm;
    Eigen::Matrix<double, 1, TurnEquations::ColsAtCompileTime> epipolar = decltype(epipolar)::Zero();
    epipolar.middleCols<3>(kTurnColumn) = point.epipolar_by_turn.transpose();
    epipolar.middleCols<24>(kCalibrationColumn) = point.epipolar_by_calibration.transpose();
    epipolar.middleCols<4>(kClockColumn) = point.by_clocks.bottomRows<1>();
    epipolar(kSeenColumn) = point.epipolar_px;

    const Eigen::Matrix<double, 6, 3> pose_weighted = place_by_pose.transpose() * point.place_weight;
    const Matrix3 turn_weighted = point.place_by_turn.transpose() * point.place_weight;
    const Vec3 epipolar_weighted = point.epipolar_by_turn * point.epipolar_weight;
    sums.pose += pose_weighted * place_by_pose;
    sums.crossed += pose_weighted.lazyProduct(place);
    sums.turn += turn_weighted.lazyProduct(place) + epipolar_weighted.lazyProduct(epipolar);
  }
  return sums;
}

double mean_side_error_mm(const WatchedPoints& points) {
  double sum_mm = 0.0;
  int sides = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++sides) {
      sum_mm +=
          (points[i].in_rig_mm - points[j].in_rig_mm).norm() - (points[i].in_target_mm - points[j].in_target_mm).norm();
    }
  }
  return sum_mm / sides;
}

}  // namespace

Eigen::Matrix<double, 6, 3> calibration_by_turn(const StereoCalibration& calibration) {
  const auto parameters_after = [&](const Vec3& turn_rad) -> Eigen::Matrix<double, 6, 1> {
    StereoCalibration turned = calibration;
    turned.right_from_left.prerotate(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()));
    return parameters_of(turned).tail<6>();
  };
  Eigen::Matrix<double, 6, 3> by_turn;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step_rad = kTurnStep_rad * Vec3::Unit(axis);
    by_turn.col(axis) = (parameters_after(step_rad) - parameters_after(-step_rad)) / (2.0 * kTurnStep_rad);
  }
  return by_turn;
}

RigCovariance covariance_or_usual(const LineModel& model) {
  if (!model.covariance.isZero(0.0)) return model.covariance;
  const Eigen::Matrix<double, 6, 3> spread = kUnstatedTurn_rad * calibration_by_turn(model.calibration);
  RigCovariance covariance = RigCovariance::Zero();
  covariance.bottomRightCorner<6, 6>() = spread * spread.transpose();
  return covariance;
}

std::optional<TurnEvidence> turn_evidence(const Pairs& pairs, const LineModel& model) {
  const Eigen::Matrix<double, 6, 3> by_turn = calibration_by_turn(model.calibration);
  WatchedPoints points;
  TurnEvidence evidence;
  for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
    const auto point = watched(pairs.pairs[i], model.target.points[i].in_target_mm, model, by_turn);
    if (!point) return std::nullopt;
    points.push_back(*point);
    evidence.place_by_turn_mm += point->place_by_turn;
  }
  evidence.place_by_turn_mm /= static_cast<double>(points.size());
  evidence.side_error_mm = mean_side_error_mm(points);

  Isometry3 pose = start_of(points);
  NormalEquations sums = around(pose, points);
  for (int i = 0; i < kRefinements; ++i) {
    pose = moved(pose, Eigen::LLT<Matrix6>(sums.pose).solve(sums.crossed.col(kSeenColumn)));
    sums = around(pose, points);
  }
  const Eigen::Matrix<double, 3, 6> gain =
      Eigen::LLT<Matrix6>(sums.pose).solve(sums.crossed.middleCols<3>(kTurnColumn)).transpose();
  evidence.equations = sums.turn - gain.lazyProduct(sums.crossed);
  if (!evidence.equations.allFinite()) return std::nullopt;
  return evidence;
}

}  // namespace tripoint
