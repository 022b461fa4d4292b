#include "line/pose/pose.h"

#include <cmath>

#include "geometry/paper.h"
#include "geometry/triangulation.h"
#include "line/pose/paper_part.h"
#include "line/pose/timing_part.h"

namespace tripoint {
namespace {

/// One pair in the reference frame.
struct Located {
  TriangulatedPoint point;
  Matrix3 shared_mm2 = Matrix3::Zero();
  Matrix3 timing_mm2 = Matrix3::Zero();
  std::optional<double> uncorrected_cost_mm;  // absent while the speed is unknown
};

PerSide<MeasuredPixel> pixels_of(const Pair& pair) {
  const auto whole = [](const AlignedPoint& point) {
    return MeasuredPixel{point.seen.at, point.seen.covariance_px2 + point.timing_px2};
  };
  return {whole(pair.points.left), whole(pair.points.right)};
}

/// How the place follows the pixels and the calibration, by the model's method.
struct Slopes {
  PerSide<Matrix32> by_pixel{Matrix32::Zero(), Matrix32::Zero()};
  Eigen::Matrix<double, 3, 24> by_calibration = Eigen::Matrix<double, 3, 24>::Zero();
};

Slopes slopes(const TriangulatedPoint& place, const PerSide<MeasuredPixel>& pixels, const LineModel& model) {
  Slopes slopes;
  const bool by_paper = model.method == Method::kPaper;
  for (const Side side : kBothSides) {
    slopes.by_pixel[side] =
        by_paper ? pixel_gain_by_paper(model.rig, pixels, side) : pixel_gain_mm_per_px(model.rig, place, pixels, side);
  }
  if (model.covariance.isZero(0.0)) return slopes;
  slopes.by_calibration = by_paper ? calibration_jacobian_by_paper(model.calibration, pixels)
                                   : calibration_jacobian(model.calibration, pixels);
  return slopes;
}

Result<Located> located(const Pair& pair, const Aligned& seen, const LineModel& model) {
  const PerSide<MeasuredPixel> pixels = pixels_of(pair);
  const Result<TriangulatedPoint> place = model.method == Method::kPaper
                                              ? triangulated_by_paper(model.rig, pixels, model.limits.min_angle_rad)
                                              : triangulated(model.rig, pixels, model.limits.min_angle_rad);
  if (!place) return tl::make_unexpected(place.error());
  const Slopes slope = slopes(*place, pixels, model);
  const Eigen::Matrix<double, 3, 24> spread = slope.by_calibration.lazyProduct(model.covariance);
  Located at{*place, spread.lazyProduct(slope.by_calibration.transpose()), Matrix3::Zero(), std::nullopt};
  for (const Side side : kBothSides) {
    const AlignedPoint& image = pair.points[side];
    const Matrix32& gain = slope.by_pixel[side];
    at.timing_mm2 += gain * image.timing_px2 * gain.transpose();
    if (side == Side::kRight && image.velocity_px_per_s) {
      at.uncorrected_cost_mm = (gain * *image.velocity_px_per_s * seen.skew_s).norm();
    }
  }
  return at;
}

double residual_square_px2(const TriangulatedPoint& point) {
  return (point.residual_px.left.squaredNorm() + point.residual_px.right.squaredNorm()) / 2.0;
}

MeasuredPoint measured_point(const Pair& pair, const Located& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  MeasuredPoint point;
  point.id = pair.id;
  point.in_output_mm = model.output_from_rig * at.point.in_rig_mm;
  point.covariance_mm2 = rotation * (at.point.covariance_mm2 + at.shared_mm2) * rotation.transpose();
  point.residual_px = std::sqrt(residual_square_px2(at.point));
  point.at = {pair.points.left.seen.at, pair.points.right.seen.at};
  point.peak_luma = {pair.points.left.seen.peak, pair.points.right.seen.peak};
  point.saturated = pair.points.left.seen.saturated || pair.points.right.seen.saturated;
  point.weak = pair.points.left.seen.weak || pair.points.right.seen.weak;
  return point;
}

TargetPose position_only(const Located& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  TargetPose pose;
  pose.position_in_output_mm = model.output_from_rig * at.point.in_rig_mm;
  pose.noise.topLeftCorner<3, 3>() = rotation * at.point.covariance_mm2 * rotation.transpose();
  pose.shared.topLeftCorner<3, 3>() = rotation * at.shared_mm2 * rotation.transpose();
  return pose;
}

}  // namespace

Fit pose_of_target(const Aligned& seen, const Pairs& pairs, const LineModel& model) {
  Fit fit;
  double squares_px2 = 0.0;
  for (const Pair& pair : pairs.pairs) {
    const Result<Located> at = located(pair, seen, model);
    if (!at) {
      fit.faults.insert(Fault::kGeometryGate);
      continue;
    }
    squares_px2 += residual_square_px2(at->point);
    fit.points.push_back(measured_point(pair, *at, model));
    if (pair.id == 0 || model.target.points.size() > 1) continue;
    fit.pose = position_only(*at, model);
    fit.timing_sigma_mm = std::sqrt(at->timing_mm2.trace());
    fit.uncorrected_cost_mm = at->uncorrected_cost_mm;
  }
  if (!fit.points.empty()) fit.residual_rms_px = std::sqrt(squares_px2 / static_cast<double>(fit.points.size()));
  return fit;
}

}  // namespace tripoint
