#include "line/match/datum.h"

#include <array>

#include <Eigen/LU>

#include "geometry/triangulation.h"
#include "line/match/epipolar.h"
#include "line/match/likeness.h"

namespace tripoint {
namespace {

using Marks = std::array<bool, kMaxImagePoints>;

MeasuredPixel measured(const AlignedPoint& point) { return {point.seen.at, point.seen.covariance_px2}; }

/// Spots within the picture of the ball around the datum; none when it does not lie in front of the camera.
Marks near_datum(const Aligned& seen, const LineModel& model, Side side) {
  Marks near{};
  const CameraModel& camera = model.rig.cameras[side];
  const Vec3 in_camera_mm = model.rig.camera_from_rig[side] * model.datum->in_rig_mm;
  const Result<RawPixel> at = projected(camera, in_camera_mm);
  if (!at) return near;
  const Matrix23 slope = projection_jacobian_px_per_mm(camera, in_camera_mm);
  const double radius_mm = model.datum->radius_mm;
  const Matrix2 per_ball = (radius_mm * radius_mm * slope * slope.transpose()).inverse();
  for (std::size_t i = 0; i < seen.points[side].size(); ++i) {
    const RawPixel& spot = seen.points[side][i].seen.at;
    const Vec2 away_px(spot.u_px - at->u_px, spot.v_px - at->v_px);
    near[i] = away_px.dot(per_ball * away_px) <= 1.0;
  }
  return near;
}

/// The datum is at rest: what the clocks may have done to a spot did nothing to it.
std::optional<Pair> within_ball(const AlignedPoint& left, const AlignedPoint& right, const LineModel& model) {
  const PerSide<MeasuredPixel> pixels{measured(left), measured(right)};
  const Result<TriangulatedPoint> place = triangulated(model.rig, pixels, model.limits.min_angle_rad);
  if (!place || (place->in_rig_mm - model.datum->in_rig_mm).norm() > model.datum->radius_mm) return std::nullopt;
  const std::optional<EpipolarGate> epipolar = epipolar_gate(model, pixels);
  if (!epipolar) return std::nullopt;
  return Pair{0, {left, right}, epipolar->distance_px, epipolar->sigma_px};
}

void leave_out(Aligned& seen, Side side, const Marks& marked) {
  FixedVector<AlignedPoint, kMaxImagePoints> kept;
  for (std::size_t i = 0; i < seen.points[side].size(); ++i) {
    if (marked[i]) {
      --seen.spots[side];
    } else {
      kept.push_back(seen.points[side][i]);
    }
  }
  seen.points[side] = kept;
}

}  // namespace

Sifted without_datum(const Aligned& seen, const LineModel& model) {
  Sifted sifted;
  sifted.others = seen;
  const PerSide<Marks> near{near_datum(seen, model, Side::kLeft), near_datum(seen, model, Side::kRight)};
  PerSide<Marks> taken{};
  for (std::size_t i = 0; i < seen.points.left.size(); ++i) {
    for (std::size_t j = 0; near.left[i] && j < seen.points.right.size(); ++j) {
      if (!near.right[j]) continue;
      const std::optional<Pair> pair = within_ball(seen.points.left[i], seen.points.right[j], model);
      if (!pair) continue;
      sifted.ambiguous = sifted.ambiguous || sifted.datum;
      sifted.datum = pair;
      taken.left[i] = taken.right[j] = true;
    }
  }
  const bool believed = sifted.datum && alike(sifted.datum->points.left.seen, sifted.datum->points.right.seen);
  if (sifted.ambiguous || !believed) sifted.datum.reset();
  for (const Side side : kBothSides) leave_out(sifted.others, side, taken[side]);
  return sifted;
}

}  // namespace tripoint
