#include "line/pose/locate.h"

#include <algorithm>
#include <cmath>

#include "geometry/paper.h"
#include "geometry/triangulation.h"
#include "line/pose/output_frame.h"
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

/// @param corner  its place among all pairs
Result<LocatedPoint> located_corner(const Pair& pair, std::size_t corner, const Aligned& seen, const LineModel& model) {
  const std::size_t of_tag = corner % kTagCorners;
  const std::size_t place = place_of_tag(pair.id, model.target);
  const TargetTag& tag = model.target.tags[place];
  Result<LocatedPoint> at =
      located(pair, {tag.id, tag.corners_mm[of_tag], tag.uncertainty_mm, std::nullopt}, seen, model);
  if (!at) return at;
  at->index = kTagCorners * place + of_tag;
  at->next = corner - of_tag + (of_tag + 1) % kTagCorners;
  for (const Side side : kBothSides) at->shared_with_next_px2[side] = pair.points[side].seen.shared_with_next_px2;
  return at;
}

Result<LocatedPoint> located_led(const Pair& pair, const Aligned& seen, const LineModel& model) {
  const auto& points = model.target.points;
  const auto same = [&](const TargetPoint& point) { return point.id == pair.id; };
  const auto* const found = std::find_if(points.begin(), points.end(), same);
  if (found == points.end()) return failure(ErrorCode::kMismatch);
  Result<LocatedPoint> at = located(pair, *found, seen, model);
  if (at) at->index = static_cast<std::size_t>(found - points.begin());
  return at;
}

}  // namespace

std::size_t place_of_tag(int id, const Target& target) {
  const auto same = [&](const TargetTag& tag) { return tag.id == id; };
  return static_cast<std::size_t>(std::find_if(target.tags.begin(), target.tags.end(), same) - target.tags.begin());
}

Result<FixedVector<LocatedPoint, kMaxImagePoints>> located_target(const Pairs& pairs, const Aligned& seen,
                                                                  const LineModel& model) {
  const bool tags = !model.target.tags.empty();
  FixedVector<LocatedPoint, kMaxImagePoints> points;
  for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
    const Pair& pair = pairs.pairs[i];
    if (!tags && pair.id == 0) continue;
    const Result<LocatedPoint> at = tags ? located_corner(pair, i, seen, model) : located_led(pair, seen, model);
    if (!at) return tl::make_unexpected(at.error());
    points.push_back(*at);
  }
  return points;
}

Result<LocatedPoint> located(const Pair& pair, const TargetPoint& of, const Aligned& seen, const LineModel& model) {
  const PerSide<MeasuredPixel> pixels = pixels_of(pair);
  const Result<TriangulatedPoint> place = model.method == Method::kPaper
                                              ? triangulated_by_paper(model.rig, pixels, model.limits.min_angle_rad)
                                              : triangulated(model.rig, pixels, model.limits.min_angle_rad);
  if (!place) return tl::make_unexpected(place.error());
  const Slopes slope = slopes(*place, pixels, model);
  LocatedPoint located;
  located.of = of;
  located.pixels = pixels;
  located.place = *place;
  located.by_pixel = slope.by_pixel;
  located.place_by_calibration = slope.by_calibration;
  for (const Side side : kBothSides) {
    const AlignedPoint& image = pair.points[side];
    located.averaging = std::min(located.averaging, image.averaging);
    located.clocks_root_px[side] = timing_root_px(image.timing_px2, image.velocity_px_per_s);
    located.moved_by_clocks_mm.middleCols<2>(side == Side::kLeft ? 0 : 2) =
        slope.by_pixel[side] * located.clocks_root_px[side];
    if (side == Side::kRight && image.velocity_px_per_s) {
      located.moved_by_skew_mm = slope.by_pixel[side] * *image.velocity_px_per_s * seen.skew_s;
    }
  }
  return located;
}

Matrix3 shared_in_output_mm2(const LocatedPoint& at, const LineModel& model) {
  const Eigen::Matrix<double, 3, 24> by_calibration =
      place_in_output_by(at.place_by_calibration, at.place.in_rig_mm, model);
  const Eigen::Matrix<double, 3, 24> spread = by_calibration.lazyProduct(model.covariance);
  return spread.lazyProduct(by_calibration.transpose());
}

double residual_square_px2(const LocatedPoint& at) {
  return (at.place.residual_px.left.squaredNorm() + at.place.residual_px.right.squaredNorm()) / 2.0;
}

MeasuredPoint measured_point(const Pair& pair, const LocatedPoint& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  MeasuredPoint point;
  point.id = pair.id;
  point.in_output_mm = model.output_from_rig * at.place.in_rig_mm;
  point.covariance_mm2 = rotation * at.place.covariance_mm2 * rotation.transpose() + shared_in_output_mm2(at, model);
  point.residual_px = std::sqrt(residual_square_px2(at));
  point.at = {pair.points.left.seen.at, pair.points.right.seen.at};
  point.peak_luma = {pair.points.left.seen.peak, pair.points.right.seen.peak};
  point.saturated = pair.points.left.seen.saturated || pair.points.right.seen.saturated;
  point.weak = pair.points.left.seen.weak || pair.points.right.seen.weak;
  return point;
}

}  // namespace tripoint
