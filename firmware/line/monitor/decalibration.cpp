#include "line/monitor/decalibration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr int kMemory = 30;                              // views: a second
constexpr int kLeastViews = 8;                           // before anything is judged
constexpr Duration kForgets = std::chrono::seconds(10);  // without a view of the target
// Spots err alike from view to view: the noise of so many views is taken for that of one.
constexpr double kAlike = 2.0;
// Chi-square with three degrees of freedom: above once in 700,000 units; below nine in ten times.
constexpr double kAlarm = 30.0;
constexpr double kOver = 6.25;
constexpr double kUsualTurn_rad = 1.7e-3;  // a tenth of a degree: how far a target is still recognised after a knock

bool is_whole(const Pairs& pairs, const LineModel& model) {
  return pairs.faults.empty() && pairs.pairs.size() == model.target.points.size();
}

}  // namespace

void Decalibration::watch(const LineModel& model) {
  *this = Decalibration{};
  turned_ = model;
  const Eigen::Matrix<double, 6, 3> spread = kUsualTurn_rad * calibration_by_turn(model.calibration);
  turned_.covariance.bottomRightCorner<6, 6>() += spread * spread.transpose();
}

void Decalibration::learn(const Aligned& seen, const Pairs& pairs, const LineModel& model) {
  if (!seen.common_time || seen.at < looked_ + kLeastApart) return;
  if (!model.calibrated || !model.calibration_fits || model.target.points.size() < 3) return;
  if (!model.target.tags.empty()) return;
  looked_ = seen.at;
  const Pairs target = is_whole(pairs, model) ? pairs : match(seen, turned_);
  if (!is_whole(target, model)) return;
  const std::optional<TurnEvidence> evidence = turn_evidence(target, model);
  if (!evidence) return;
  add(*evidence, seen.at);
  judge(model, evidence->place_by_turn_mm);
}

void Decalibration::add(const TurnEvidence& evidence, TimePoint at) {
  if (!found_.alarm && at > found_.newest + kForgets) found_ = Findings{};
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
}

void Decalibration::judge(const LineModel& model, const Matrix3& place_by_turn_mm) {
  const TurnEquations& sums = found_.sums;
  const Matrix3 information = sums.middleCols<3>(kTurnColumn);
  const Vec3 seen = sums.col(kSeenColumn);
  const Eigen::Matrix<double, 3, 24> by_calibration = sums.middleCols<24>(kCalibrationColumn);
  const Eigen::Matrix<double, 3, 24> calibration = by_calibration.lazyProduct(model.covariance);
  // Clocks err alike from view to view, but not the same: by Cauchy and Schwarz their sum spreads no more than this.
  Matrix3 spread = kAlike * information + calibration.lazyProduct(by_calibration.transpose()) +
                   found_.clock_sigmas * found_.clock_spreads;
  for (std::size_t i = 0; i < model.target.points.size(); ++i) {
    const Matrix3 by_point = sums.middleCols<3>(kTargetColumn + 3 * static_cast<Eigen::Index>(i));
    const double sigma_mm = model.target.points[i].uncertainty_mm / 2.0;
    spread += sigma_mm * sigma_mm * by_point * by_point.transpose();
  }
  const double chi2 = seen.dot(Eigen::LDLT<Matrix3>(spread).solve(seen));
  found_.moved_mm = (place_by_turn_mm * Eigen::LDLT<Matrix3>(information).solve(seen)).norm();
  found_.alarm = found_.views >= kLeastViews && chi2 > (found_.alarm ? kOver : kAlarm);
}

Measurement Decalibration::judged(Measurement measurement) const {
  if (found_.views >= kLeastViews) {
    measurement.side_length_error_mm = found_.side_error_mm;
    measurement.decalibration_mm = found_.moved_mm;
  }
  if (found_.alarm) {
    measurement.faults.insert(Fault::kDecalibration);
    measurement.pose.reset();
  }
  return measurement;
}

}  // namespace tripoint
