#include "line/gate/gate.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kRotationError = 1e-6;  // double precision leaves 1e-15; NaN fails too

Faults faults_of_model(const LineModel& model) {
  Faults faults;
  if (!model.calibrated) faults.insert(Fault::kNoCalibration);
  if (model.calibrated && !model.calibration_fits) faults.insert(Fault::kCalibrationDoesNotFit);
  return faults;
}

bool inside(const WorkingVolume& volume, const Vec3& point_in_rig_mm) {
  const Vec3 point_mm = volume.from_rig * point_in_rig_mm;
  return (point_mm.array() >= volume.min_mm.array()).all() && (point_mm.array() <= volume.max_mm.array()).all();
}

Faults faults_of_fit(const Fit& fit, const LineModel& model) {
  Faults faults = fit.faults;
  if (!fit.pose) return faults;
  const Vec3 position_in_rig_mm = model.output_from_rig.inverse() * fit.pose->position_in_output_mm;
  if (model.volume && !inside(*model.volume, position_in_rig_mm)) faults.insert(Fault::kOutsideVolume);
  if (!(fit.timing_sigma_mm <= model.limits.timing_bound_mm)) faults.insert(Fault::kTimingBound);
  return faults;
}

bool has_positive_diagonal(const Matrix3& covariance) { return (covariance.diagonal().array() > 0.0).all(); }

bool is_rotation(const Matrix3& matrix) {
  return (matrix * matrix.transpose() - Matrix3::Identity()).norm() < kRotationError && matrix.determinant() > 0.0;
}

bool is_whole(const TargetPose& pose) {
  const bool positioned = pose.position_in_output_mm.allFinite() && pose.noise.allFinite() && pose.shared.allFinite() &&
                          has_positive_diagonal(pose.noise.topLeftCorner<3, 3>());
  if (!pose.output_from_target) return positioned;
  return positioned && is_rotation(*pose.output_from_target) &&
         has_positive_diagonal(pose.noise.bottomRightCorner<3, 3>());
}

bool is_whole(const MeasuredPoint& point) {
  return point.in_output_mm.allFinite() && point.covariance_mm2.allFinite() && std::isfinite(point.residual_px) &&
         std::isfinite(point.at.left.u_px + point.at.left.v_px + point.at.right.u_px + point.at.right.v_px) &&
         std::isfinite(point.peak_luma.left + point.peak_luma.right);
}

bool is_whole(const ImageHealth& health) {
  return std::isfinite(health.mean_luma + health.peak_luma + health.dimmest_luma + health.focus);
}

bool is_whole(const Aligned& seen, const Fit& fit) {
  const auto whole = [](const MeasuredPoint& point) { return is_whole(point); };
  return std::all_of(fit.points.begin(), fit.points.end(), whole) && (!fit.pose || is_whole(*fit.pose)) &&
         std::isfinite(fit.residual_rms_px) && std::isfinite(fit.uncorrected_cost_mm.value_or(0.0)) &&
         std::isfinite(seen.skew_s) && std::isfinite(seen.offset_sigma_s);
}

/// From the points that were measured: marks of the detector, and residuals above the chi-square limit.
Warnings warnings_of(const Pairs& pairs, const Fit& fit, const LineModel& model) {
  Warnings warnings;
  for (const MeasuredPoint& point : fit.points) {
    if (point.saturated) warnings.insert(Warning::kSaturatedSpot);
    if (point.weak) warnings.insert(Warning::kWeakSpot);
  }
  for (const Pair& pair : pairs.pairs) {
    const double sigmas = pair.epipolar_px / pair.epipolar_sigma_px;
    if (sigmas * sigmas > model.limits.weak_chi2) warnings.insert(Warning::kHighResidual);
  }
  return warnings;
}

}  // namespace

Measurement gate(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model) {
  Measurement measurement;
  measurement.exposed = seen.at;
  measurement.exposure_began = seen.exposure_began;
  measurement.common_time = seen.common_time;
  measurement.spots = seen.spots;
  for (const Faults& faults : {seen.faults, pairs.faults, faults_of_fit(fit, model), faults_of_model(model)}) {
    measurement.faults.insert(faults);
  }
  for (const Side side : kBothSides) {
    if (is_whole(seen.health[side])) {
      measurement.health[side] = seen.health[side];
    } else {
      measurement.faults.insert(Fault::kInternal);
    }
  }
  if (!is_whole(seen, fit)) {
    measurement.faults.insert(Fault::kInternal);
    return measurement;
  }
  measurement.warnings = seen.warnings;
  measurement.warnings.insert(warnings_of(pairs, fit, model));
  measurement.timing.skew_s = seen.skew_s;
  measurement.timing.skew_sigma_s = seen.offset_sigma_s;
  measurement.timing.uncorrected_cost_mm = fit.uncorrected_cost_mm;
  measurement.points = fit.points;
  measurement.residual_rms_px = fit.residual_rms_px;
  if (!fit.pose && measurement.faults.empty()) measurement.faults.insert(Fault::kInternal);  // nothing without a cause
  if (measurement.faults.empty()) measurement.pose = fit.pose;
  return measurement;
}

}  // namespace tripoint
