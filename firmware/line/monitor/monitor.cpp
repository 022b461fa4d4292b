#include "line/monitor/monitor.h"

#include <cmath>

#include "geometry/camera_model.h"

namespace tripoint {
namespace {

constexpr double kEpipolarMemory = 32.0;  // pairs, about half a second to a second
constexpr double kSpotSigma_px = 0.5;     // a forecast is never taken for more exact than that

/// Nothing when the point lies behind a camera.
std::optional<ForecastPoint> seen_by_both(const PredictedPosition& position, const LineModel& model) {
  const Isometry3 rig_from_output = model.output_from_rig.inverse();
  ForecastPoint point;
  point.id = model.target.points.empty() ? 0 : model.target.points[0].id;
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
  }
  return point;
}

}  // namespace

void Monitor::learn(const Measurement& measurement, const Pairs& pairs) {
  ++learned_;
  if (measurement.common_time) common_time_ = measurement.exposed;
  if (measurement.pose) motion_.take(measurement.exposed, *measurement.pose);
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
  if (!position) return forecast;
  const std::optional<ForecastPoint> point = seen_by_both(*position, model);
  if (point) forecast.points.push_back(*point);
  return forecast;
}

}  // namespace tripoint
