#include "line/pose/pose.h"

#include <cmath>

#include "geometry/paper.h"
#include "geometry/triangulation.h"
#include "line/pose/body_pose.h"
#include "line/pose/paper_part.h"
#include "line/pose/timing_part.h"

namespace tripoint {
namespace {

PerSide<MeasuredPixel> pixels_of(const Pair& pair) {
  const auto whole = [](const AlignedPoint& point) {
    return MeasuredPixel{point.seen.at, point.seen.covariance_px2 + point.timing_px2};
  };
  return {whole(pair.points.left), whole(pair.points.right)};
}

TargetPoint point_of_target(int id, const Target& target) {
  for (const TargetPoint& point : target.points) {
    if (point.id == id) return point;
  }
  return {.id = id};
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

Result<LocatedPoint> located(const Pair& pair, const Aligned& seen, const LineModel& model) {
  const PerSide<MeasuredPixel> pixels = pixels_of(pair);
  const Result<TriangulatedPoint> place = model.method == Method::kPaper
                                              ? triangulated_by_paper(model.rig, pixels, model.limits.min_angle_rad)
                                              : triangulated(model.rig, pixels, model.limits.min_angle_rad);
  if (!place) return tl::make_unexpected(place.error());
  const Slopes slope = slopes(*place, pixels, model);
  LocatedPoint located;
  located.of = point_of_target(pair.id, model.target);
  located.pixels = pixels;
  located.place = *place;
  located.place_by_calibration = slope.by_calibration;
  for (const Side side : kBothSides) {
    const AlignedPoint& image = pair.points[side];
    located.moved_by_clocks_mm.middleCols<2>(side == Side::kLeft ? 0 : 2) =
        slope.by_pixel[side] * timing_root_px(image.timing_px2, image.velocity_px_per_s);
    if (side == Side::kRight && image.velocity_px_per_s) {
      located.moved_by_skew_mm = slope.by_pixel[side] * *image.velocity_px_per_s * seen.skew_s;
    }
  }
  return located;
}

Matrix3 shared_mm2(const LocatedPoint& at, const LineModel& model) {
  const Eigen::Matrix<double, 3, 24> spread = at.place_by_calibration.lazyProduct(model.covariance);
  return spread.lazyProduct(at.place_by_calibration.transpose());
}

double residual_square_px2(const TriangulatedPoint& point) {
  return (point.residual_px.left.squaredNorm() + point.residual_px.right.squaredNorm()) / 2.0;
}

MeasuredPoint measured_point(const Pair& pair, const LocatedPoint& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  MeasuredPoint point;
  point.id = pair.id;
  point.in_output_mm = model.output_from_rig * at.place.in_rig_mm;
  point.covariance_mm2 = rotation * (at.place.covariance_mm2 + shared_mm2(at, model)) * rotation.transpose();
  point.residual_px = std::sqrt(residual_square_px2(at.place));
  point.at = {pair.points.left.seen.at, pair.points.right.seen.at};
  point.peak_luma = {pair.points.left.seen.peak, pair.points.right.seen.peak};
  point.saturated = pair.points.left.seen.saturated || pair.points.right.seen.saturated;
  point.weak = pair.points.left.seen.weak || pair.points.right.seen.weak;
  return point;
}

/// Of a target that is a single point.
BodyPose position_only(const LocatedPoint& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  BodyPose pose;
  pose.in_output.position_in_output_mm = model.output_from_rig * at.place.in_rig_mm;
  const double mounted_mm = at.of.uncertainty_mm / 2.0;
  pose.in_output.noise.topLeftCorner<3, 3>() =
      rotation * at.place.covariance_mm2 * rotation.transpose() + mounted_mm * mounted_mm * Matrix3::Identity();
  pose.in_output.shared.topLeftCorner<3, 3>() = rotation * shared_mm2(at, model) * rotation.transpose();
  pose.timing_sigma_mm = at.moved_by_clocks_mm.norm();
  if (at.moved_by_skew_mm) pose.uncorrected_cost_mm = at.moved_by_skew_mm->norm();
  return pose;
}

using LocatedPoints = FixedVector<LocatedPoint, kMaxTargetPoints>;

/// Nothing unless all points of the target were identified.
Result<std::optional<BodyPose>> body_pose(const LocatedPoints& identified, const LineModel& model) {
  if (identified.empty() || identified.size() != model.target.points.size()) return std::optional<BodyPose>{};
  if (identified.size() == 1) return std::optional<BodyPose>{position_only(identified[0], model)};
  if (identified.size() == 2) return std::optional<BodyPose>{};
  const Result<BodyPose> pose = pose_of_body({identified.begin(), identified.size()}, model);
  if (!pose) return tl::make_unexpected(pose.error());
  return std::optional<BodyPose>{*pose};
}

}  // namespace

Fit pose_of_target(const Aligned& seen, const Pairs& pairs, const LineModel& model) {
  Fit fit;
  LocatedPoints identified;
  double squares_px2 = 0.0;
  for (const Pair& pair : pairs.pairs) {
    const Result<LocatedPoint> at = located(pair, seen, model);
    if (!at) {
      fit.faults.insert(Fault::kGeometryGate);
      continue;
    }
    squares_px2 += residual_square_px2(at->place);
    fit.points.push_back(measured_point(pair, *at, model));
    if (pair.id != 0) identified.push_back(*at);
  }
  if (!fit.points.empty()) fit.residual_rms_px = std::sqrt(squares_px2 / static_cast<double>(fit.points.size()));
  const Result<std::optional<BodyPose>> pose = body_pose(identified, model);
  if (!pose) fit.faults.insert(Fault::kGeometryGate);
  if (!pose || !*pose) return fit;
  fit.pose = (*pose)->in_output;
  fit.timing_sigma_mm = (*pose)->timing_sigma_mm;
  fit.uncorrected_cost_mm = (*pose)->uncorrected_cost_mm;
  return fit;
}

}  // namespace tripoint
