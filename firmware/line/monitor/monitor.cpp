#include "line/monitor/monitor.h"

#include <chrono>
#include <cmath>

#include "geometry/camera_model.h"

namespace tripoint {
namespace {

constexpr double kEpipolarMemory = 32.0;      // pairs, about half a second to a second
constexpr double kSpotSigma_px = 0.5;         // a forecast is never taken for more exact than that
constexpr double kUsualTurn_rad_per_s = 1.0;  // standard deviation, of a wrist that turns a tool

constexpr Duration kLately = std::chrono::milliseconds(500);  // as long as a motion is known without a position

/// Nothing when the point lies behind a camera.
std::optional<ForecastPoint> seen_by_both(int id, const PredictedPosition& position, const LineModel& model) {
  const Isometry3 rig_from_output = model.output_from_rig.inverse();
  ForecastPoint point;
  point.id = id;
  for (const Side side : kBothSides) {
    const Isometry3 camera_from_output = model.rig.camera_from_rig[side] * rig_from_output;
    const Vec3 in_camera = camera_from_output * position.in_output_mm;
    const Result<RawPixel> at = projected(model.rig.cameras[side], in_camera);
    if (!at) return std::nullopt;
    const Matrix23 jacobian =
        projection_jacobian_px_per_mm(model.rig.cameras[side], in_camera) * camera_from_output.linear();
    point.at[side] = *at;
    point.covariance_px2[side] =
        jacobian * position.covariance_mm2 * jacobian.transpose() + kSpotSigma_px * kSpotSigma_px * Matrix2::Identity();
    point.velocity_px_per_s[side] = jacobian * position.velocity_mm_per_s;
  }
  return point;
}

/// The same for a point beside the origin, which a turn of the target moves too.
PredictedPosition beside(const PredictedPosition& origin, const Vec3& offset_mm, double ahead_s) {
  const double turn_mm = kUsualTurn_rad_per_s * ahead_s * offset_mm.norm();
  return {origin.in_output_mm + offset_mm, origin.covariance_mm2 + turn_mm * turn_mm * Matrix3::Identity(),
          origin.velocity_mm_per_s};
}

}  // namespace

void Monitor::learn(const Measurement& measurement, const Pairs& pairs) {
  ++learned_;
  if (measurement.common_time) common_time_ = measurement.exposed;
  if (measurement.pose) {
    motion_.take(measurement.exposed, *measurement.pose);
    output_from_target_ = measurement.pose->output_from_target;
  }
  if (pairs.datum) {
    datum_seen_ = measurement.exposed;
    datum_at_ = {pairs.datum->points.left.seen.at, pairs.datum->points.right.seen.at};
  }
  for (const Pair& pair : pairs.pairs) {
    const double square_px2 = pair.epipolar_px * pair.epipolar_px;
    epipolar_square_px2_ += (square_px2 - epipolar_square_px2_) / (epipolar_known_ ? kEpipolarMemory : 1.0);
    epipolar_known_ = true;
  }
}

Measurement Monitor::completed(Measurement measurement, const LineModel& model) const {
  measurement.sequence = learned_;
  measurement.epipolar_rms_px = std::sqrt(epipolar_square_px2_);
  if (measurement.pose) {
    measurement.timing.speed_mm_per_s = motion_.speed_mm_per_s().value_or(0.0);
    measurement.timing.settled = motion_.settled(model.limits.settled_mm_per_s);
  }
  return measurement;
}

Forecast Monitor::forecast(Duration ahead, const LineModel& model) const {
  Forecast forecast;
  forecast.number = learned_;
  forecast.at = common_time_ + ahead;
  const std::optional<PredictedPosition> position = model.calibrated ? motion_.position_at(forecast.at) : std::nullopt;
  const FixedVector<TargetPoint, kMaxTargetPoints>& points = model.target.points;
  if (!position || (points.size() > 1 && !output_from_target_)) return forecast;
  for (const TargetPoint& point : points) {
    const Vec3 offset_mm = output_from_target_ ? Vec3(*output_from_target_ * point.in_target_mm) : Vec3(Vec3::Zero());
    const auto seen = seen_by_both(point.id, beside(*position, offset_mm, seconds(ahead)), model);
    if (!seen) {
      forecast.points.clear();
      return forecast;
    }
    forecast.points.push_back(*seen);
  }
  if (model.datum && common_time_ - datum_seen_ <= kLately) {
    const Matrix2 spot_px2 = kSpotSigma_px * kSpotSigma_px * Matrix2::Identity();
    forecast.points.push_back({.id = 0, .at = datum_at_, .covariance_px2 = {spot_px2, spot_px2}});
  }
  return forecast;
}

}  // namespace tripoint
