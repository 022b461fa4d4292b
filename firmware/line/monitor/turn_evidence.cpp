#include "line/monitor/turn_evidence.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "geometry/rigid_fit.h"
#include "geometry/triangulation.h"
#include "line/pose/pixel_rows.h"

namespace tripoint {
namespace {

constexpr double kUnstatedTurn_rad = 1e-4;  // standard deviation, of a calibration that does not state its own
constexpr double kTurnStep_rad = 1e-5;
constexpr double kMostTiming = 9.0;  // variance of the clocks' part over that of a spot
constexpr int kMostSteps = 20;       // of the pose: 2 or 3 are usual
constexpr double kSettled = 1e-6;    // of a step, mm and rad times the distance, over the distance

using Points = std::span<const LocatedPoint>;
using RowsByTurn = Eigen::Matrix<double, Eigen::Dynamic, kTurnColumns, 0, kMostRows, kTurnColumns>;

bool timed_well(const LocatedPoint& point) {
  return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
    const double timing_px2 = point.clocks_root_px[side].squaredNorm();
    return timing_px2 <= kMostTiming * (point.pixels[side].covariance_px2.trace() - timing_px2);
  });
}

/// Pixels with what moves them, whitened.
struct Part {
  PixelOffset offset;
  Eigen::LLT<PixelCovariance> root;
};

/// @return nothing when a point lies behind a camera
std::optional<Part> part_at(const Isometry3& pose, Points points, const Rig& rig) {
  std::optional<PixelOffset> offset = pixel_offset(pose, points, rig);
  if (!offset) return std::nullopt;
  Part part{*offset, Eigen::LLT<PixelCovariance>(spots_covariance_px2(points))};
  if (part.root.info() != Eigen::Success) return std::nullopt;
  part.root.matrixL().solveInPlace(part.offset.px);
  part.root.matrixL().solveInPlace(part.offset.by_pose);
  return part;
}

/// The likeliest pose by the image points alone: Gauss and Newton.
std::optional<Isometry3> best_pose(Points points, Isometry3 pose, const Rig& rig) {
  for (int i = 0; i < kMostSteps; ++i) {
    Matrix6 information = Matrix6::Zero();
    PoseParameters gradient = PoseParameters::Zero();
    for (std::size_t first = 0; first < points.size();) {
      const Points own = part_from(points, first);
      const std::optional<Part> part = part_at(pose, own, rig);
      if (!part) return std::nullopt;
      information += part->offset.by_pose.transpose().lazyProduct(part->offset.by_pose);
      gradient += part->offset.by_pose.transpose().lazyProduct(part->offset.px);
      first += own.size();
    }
    const PoseParameters step = Eigen::LLT<Matrix6>(information).solve(gradient);
    if (!step.allFinite()) return std::nullopt;
    pose = moved(pose, step);
    const double distance_mm = pose.translation().norm();
    if (step.head<3>().norm() + distance_mm * step.tail<3>().norm() <= kSettled * distance_mm) return pose;
  }
  return std::nullopt;
}

/// How a corner of a tag moves when both its edges move inwards by a pixel, as a tone curve or sharpening moves them.
Vec2 moved_by_edges(const RawPixel& before, const RawPixel& corner, const RawPixel& after) {
  const auto inwards = [](const RawPixel& from, const RawPixel& to) -> Vec2 {  // corners run counter-clockwise
    return Vec2(to.v_px - from.v_px, from.u_px - to.u_px).normalized();
  };
  Matrix2 edges;
  edges << inwards(before, corner).transpose(), inwards(corner, after).transpose();
  return edges.inverse() * Vec2::Ones();
}

/// How the offsets of one part's pixels follow the columns; what was seen is left out. Not whitened.
RowsByTurn rows_by_turn(Points part, const Isometry3& pose, const LineModel& model,
                        const Eigen::Matrix<double, 6, 3>& by_turn) {
  RowsByTurn rows = RowsByTurn::Zero(row_of(part.size()), kTurnColumns);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const LocatedPoint& point = part[i];
    auto own = rows.middleRows<kPixels>(row_of(i));
    own.middleCols<24>(kCalibrationColumn) = -pixels_by_calibration(model.calibration, point.place.in_rig_mm);
    own.middleCols<3>(kTurnColumn) = own.middleCols<6>(kCalibrationColumn + 18) * by_turn;
    for (const Side side : kBothSides) {
      own.block<2, 2>(first_row(side), kClockColumn + first_row(side)) = point.clocks_root_px[side];
      if (!point.next) continue;
      const auto corner = [&](std::size_t k) -> const RawPixel& { return part[k % kTagCorners].pixels[side].at; };
      own.block<2, 1>(first_row(side), kEdgesColumn) =
          moved_by_edges(corner(i + kTagCorners - 1), corner(i), corner(i + 1));
    }
    own.middleCols<3>(kTargetColumn + 3 * static_cast<Eigen::Index>(point.index)) =
        -pixels_by_place(model.rig, pose * point.of.in_target_mm) * pose.linear();
  }
  return rows;
}

/// Of the part's points together.
Matrix3 places_by_turn_mm(Points part, const RowsByTurn& rows) {
  Matrix3 moved = Matrix3::Zero();
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (const Side side : kBothSides) {
      moved += part[i].by_pixel[side] * rows.block<2, 3>(row_of(i) + first_row(side), kTurnColumn);
    }
  }
  return moved;
}

double mean_side_error_mm(Points points) {
  double sum_mm = 0.0;
  int sides = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++sides) {
      sum_mm += (points[i].place.in_rig_mm - points[j].place.in_rig_mm).norm() -
                (points[i].of.in_target_mm - points[j].of.in_target_mm).norm();
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

std::optional<TurnEvidence> turn_evidence(Points points, const Isometry3& start, const LineModel& model) {
  if (!std::all_of(points.begin(), points.end(), timed_well)) return std::nullopt;
  const std::optional<Isometry3> pose = best_pose(points, start, model.rig);
  if (!pose) return std::nullopt;
  const Eigen::Matrix<double, 6, 3> by_turn = calibration_by_turn(model.calibration);
  Matrix6 by_pose = Matrix6::Zero();
  Eigen::Matrix<double, 6, kTurnColumns> crossed = Eigen::Matrix<double, 6, kTurnColumns>::Zero();
  TurnEvidence evidence;
  for (std::size_t first = 0; first < points.size();) {
    const Points own = part_from(points, first);
    const std::optional<Part> part = part_at(*pose, own, model.rig);
    if (!part) return std::nullopt;
    RowsByTurn rows = rows_by_turn(own, *pose, model, by_turn);
    evidence.place_by_turn_mm += places_by_turn_mm(own, rows) / static_cast<double>(points.size());
    part->root.matrixL().solveInPlace(rows);
    rows.col(kSeenColumn) = part->offset.px;
    by_pose += part->offset.by_pose.transpose().lazyProduct(part->offset.by_pose);
    crossed += part->offset.by_pose.transpose().lazyProduct(rows);
    evidence.equations += rows.middleCols<3>(kTurnColumn).transpose().lazyProduct(rows);
    first += own.size();
  }
  const Eigen::Matrix<double, 3, 6> gain =
      Eigen::LLT<Matrix6>(by_pose).solve(crossed.middleCols<3>(kTurnColumn)).transpose();
  evidence.equations -= gain.lazyProduct(crossed);
  evidence.side_error_mm = mean_side_error_mm(points);
  if (!evidence.equations.allFinite()) return std::nullopt;
  return evidence;
}

}  // namespace tripoint
