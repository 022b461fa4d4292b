#include "line/monitor/decalibration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "line/pose/locate.h"

namespace tripoint {
namespace {

constexpr int kMemory = 30;         // views: a second
constexpr int kLeastViews = 4;      // before anything is judged
constexpr double kEdges_px = 0.05;  // standard deviation by which a camera moves all edges of tags inwards
// Chi-square with three degrees of freedom: above once in 700,000 units, and in 6,000.
constexpr double kAlarm = 30.0;
constexpr double kExcluded = 20.0;
constexpr double kUsualTurn_rad = 1.7e-3;  // a tenth of a degree: how far a target is still recognised after a knock

/// Whether a target of so many LEDs, or of tags, shows how the cameras stand.
bool shows_turns(const Target& target) { return target.points.size() >= 3 || !target.tags.empty(); }

/// Standard deviation of each place of the target, by LocatedPoint::index.
FixedVector<double, kMostTargetPlaces> place_sigmas_mm(const Target& target) {
  FixedVector<double, kMostTargetPlaces> sigmas_mm;
  for (const TargetTag& tag : target.tags) {
    for (std::size_t corner = 0; corner < kTagCorners; ++corner) sigmas_mm.push_back(tag.uncertainty_mm / 2.0);
  }
  if (!target.tags.empty()) return sigmas_mm;
  for (const TargetPoint& point : target.points) sigmas_mm.push_back(point.uncertainty_mm / 2.0);
  return sigmas_mm;
}

bool same_target(const Target& a, const Target& b) {
  const auto same_point = [](const TargetPoint& one, const TargetPoint& other) {
    return one.id == other.id && one.in_target_mm == other.in_target_mm && one.uncertainty_mm == other.uncertainty_mm;
  };
  const auto same_tag = [](const TargetTag& one, const TargetTag& other) {
    return one.id == other.id && one.corners_mm == other.corners_mm && one.uncertainty_mm == other.uncertainty_mm;
  };
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same_point) &&
         std::equal(a.tags.begin(), a.tags.end(), b.tags.begin(), b.tags.end(), same_tag);
}

/// Whether what was found by one model is true of the other.
bool same_mount(const LineModel& a, const LineModel& b) {
  if (a.datum.has_value() != b.datum.has_value()) return false;
  if (a.datum && a.datum->in_rig_mm != b.datum->in_rig_mm) return false;
  return parameters_of(a.calibration) == parameters_of(b.calibration) && same_target(a.target, b.target);
}

}  // namespace

void Decalibration::watch(const LineModel& model) {
  if (!same_mount(model, turned_)) *this = Decalibration{};
  turned_ = model;
  const Eigen::Matrix<double, 6, 3> spread = kUsualTurn_rad * calibration_by_turn(model.calibration);
  turned_.covariance.bottomRightCorner<6, 6>() += spread * spread.transpose();
}

void Decalibration::learn(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model) {
  if (!seen.common_time || !seen.faults.empty()) return;
  if (!model.calibrated || !model.calibration_fits) return;
  if (model.datum && pairs.datum) datum_.learn(*pairs.datum, seen.at, model);
  if (!shows_turns(model.target)) return;
  const auto too_soon = [&](TimePoint last) { return seen.at >= last && seen.at < last + kLeastApart; };
  if (too_soon(found_.newest)) return;
  if (pairs.faults.empty() && fit.pose) {
    take(seen, pairs, fit, model);
  } else if (!too_soon(searched_)) {
    searched_ = seen.at;
    const Pairs target = match(seen, turned_);
    if (!target.faults.empty()) return;
    const Fit turned = pose_of_target(seen, target, turned_);
    if (turned.pose) take(seen, target, turned, model);
  }
}

void Decalibration::take(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model) {
  const auto points = located_target(pairs, seen, model);
  if (!points || !fit.pose->output_from_target) return;
  Isometry3 output_from_target = Isometry3::Identity();
  output_from_target.linear() = *fit.pose->output_from_target;
  output_from_target.translation() = fit.pose->position_in_output_mm;
  const Isometry3 rig_from_target = model.output_from_rig.inverse() * output_from_target;
  const auto evidence = turn_evidence({points->begin(), points->size()}, rig_from_target, model);
  if (!evidence) return;
  add(*evidence, {points->begin(), points->size()}, seen.at);
  judge(model, evidence->place_by_turn_mm);
}

void Decalibration::add(const TurnEvidence& evidence, std::span<const LocatedPoint> points, TimePoint at) {
  found_.newest = at;
  found_.views = std::min(found_.views + 1, kMemory);
  const double kept = 1.0 - 1.0 / kMemory;
  const Eigen::Matrix<double, 3, 4> by_clocks = evidence.equations.middleCols<4>(kClockColumn);
  found_.sums = kept * found_.sums + evidence.equations;
  found_.clock_sigmas = kept * found_.clock_sigmas;
  found_.clock_spreads = kept * found_.clock_spreads;
  if (const double sigma = by_clocks.norm(); sigma > 0.0) {
    found_.clock_sigmas += sigma;
    found_.clock_spreads += by_clocks * by_clocks.transpose() / sigma;
  }
  found_.side_error_mm += (evidence.side_error_mm - found_.side_error_mm) / found_.views;
  found_.noise.add(kept, evidence.equations.middleCols<3>(kTurnColumn), points);
}

Matrix3 Decalibration::spread_without_turn(const LineModel& model) const {
  const TurnEquations& sums = found_.sums;
  // Clocks err alike from view to view, but not the same: by Cauchy and Schwarz their sum spreads no more than this.
  Matrix3 spread = found_.noise.covariance() + found_.clock_sigmas * found_.clock_spreads;
  const Vec3 by_edges = sums.col(kEdgesColumn);
  spread += kEdges_px * kEdges_px * by_edges * by_edges.transpose();
  const Eigen::Matrix<double, 3, 24> by_calibration = sums.middleCols<24>(kCalibrationColumn);
  const Eigen::Matrix<double, 3, 24> calibration = by_calibration.lazyProduct(covariance_or_usual(model));
  spread += calibration.lazyProduct(by_calibration.transpose());
  Eigen::Index column = kTargetColumn;
  for (const double sigma_mm : place_sigmas_mm(model.target)) {
    const Matrix3 by_place = sums.middleCols<3>(column);
    spread += sigma_mm * sigma_mm * by_place * by_place.transpose();
    column += 3;
  }
  return spread;
}

void Decalibration::judge(const LineModel& model, const Matrix3& place_by_turn_mm) {
  const Matrix3 information = found_.sums.middleCols<3>(kTurnColumn);
  const Vec3 seen = found_.sums.col(kSeenColumn);
  const Eigen::LDLT<Matrix3> spread(spread_without_turn(model));
  const auto chi2 = [&](const Vec3& turn_rad) -> double {
    const Vec3 unexplained = seen - information * turn_rad;
    return unexplained.dot(spread.solve(unexplained));
  };
  const Vec3 turn_rad = Eigen::LDLT<Matrix3>(information).solve(seen);
  const double without = chi2(Vec3::Zero());
  found_.moved_mm = (place_by_turn_mm * turn_rad).norm();
  if (found_.views < kLeastViews) return;
  if (without > std::max(kAlarm, found_.alarm ? found_.alarm_chi2 : 0.0)) {
    found_.alarm = true;
    found_.alarm_chi2 = without;
    found_.alarm_turn_rad = turn_rad;
  } else if (found_.alarm && without < kExcluded && chi2(found_.alarm_turn_rad) > kExcluded) {
    found_.alarm = false;
  }
}

Measurement Decalibration::judged(Measurement measurement) const {
  if (found_.views >= kLeastViews && measurement.exposed <= found_.newest + kFindingShown) {
    measurement.side_length_error_mm = found_.side_error_mm;
    if (std::isfinite(found_.moved_mm)) measurement.decalibration_mm = found_.moved_mm;
  }
  if (const std::optional<double> datum_mm = datum_.moved_mm(measurement.exposed)) {
    measurement.decalibration_mm = std::max(measurement.decalibration_mm.value_or(0.0), *datum_mm);
  }
  measurement.mount_watched = measurement.common_time && datum_.watched(measurement.exposed);
  if (found_.alarm || datum_.alarm()) {
    measurement.faults.insert(Fault::kDecalibration);
    measurement.pose.reset();
    for (MeasuredPoint& point : measurement.points) point.id = 0;
  }
  return measurement;
}

}  // namespace tripoint
