#include "line/monitor/datum_watch.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "line/monitor/pair_evidence.h"
#include "line/monitor/turn_evidence.h"

namespace tripoint {
namespace {

constexpr int kMemory = 10;  // views: a third of a second
// Chi-square with four degrees of freedom: above once in 800,000 units, and in 5,000.
constexpr double kAlarm = 33.0;
constexpr double kExcluded = 22.0;

struct View {
  Eigen::Vector4d offset = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
};

/// With the covariance of one picture: at rest an LED errs alike in the two pictures that its place lies between.
Pair at_rest(Pair datum) {
  for (const Side side : kBothSides) datum.points[side].seen.covariance_px2 /= datum.points[side].averaging;
  return datum;
}

/// Nothing when the rays do not meet in front of both cameras or no number comes out.
std::optional<View> view_of(const Pair& datum, const LineModel& model) {
  const std::optional<PairEvidence> seen = pair_evidence(at_rest(datum), model);
  if (!seen) return std::nullopt;
  Eigen::Matrix<double, 4, 24> by_calibration;
  by_calibration << seen->place_by_calibration, seen->epipolar_by_calibration.transpose();
  const Eigen::Matrix<double, 4, 24> calibration = by_calibration.lazyProduct(covariance_or_usual(model));
  const double own_mm = model.datum->uncertainty_mm / 2.0;

  View view;
  view.offset << seen->place.in_rig_mm - model.datum->in_rig_mm, seen->epipolar.distance_px;
  view.covariance = calibration.lazyProduct(by_calibration.transpose());
  view.covariance.topLeftCorner<3, 3>() += seen->place.covariance_mm2 + own_mm * own_mm * Matrix3::Identity();
  view.covariance(3, 3) += seen->epipolar.noise_px2;
  if (!view.offset.allFinite() || !view.covariance.allFinite()) return std::nullopt;
  return view;
}

}  // namespace

void DatumWatch::learn(const Pair& datum, TimePoint at, const LineModel& model) {
  const std::optional<View> view = view_of(datum, model);
  if (!view) return;
  if (at > newest_ + kPause) views_ = 0;  // a datum that shows now and then says little of now
  newest_ = at;
  views_ = std::min(views_ + 1, kMemory);
  offset_ += (view->offset - offset_) / views_;
  covariance_ += (view->covariance - covariance_) / views_;
  if (views_ >= kLeastViews) judge();
}

void DatumWatch::judge() {
  const Eigen::LDLT<Eigen::Matrix4d> covariance(covariance_);
  const auto chi2 = [&](const Offset& explained) -> double {
    const Offset unexplained = offset_ - explained;
    return unexplained.dot(covariance.solve(unexplained));
  };
  const double without = chi2(Offset::Zero());
  if (without > std::max(kAlarm, alarm_ ? alarm_chi2_ : 0.0)) {
    alarm_ = true;
    alarm_chi2_ = without;
    alarm_offset_ = offset_;
  } else if (alarm_ && without < kExcluded && chi2(alarm_offset_) > kExcluded) {
    alarm_ = false;
  }
}

std::optional<double> DatumWatch::moved_mm(TimePoint at) const {
  if (views_ < kLeastViews || at > newest_ + kFindingShown) return std::nullopt;
  return offset_.head<3>().norm();
}

bool DatumWatch::watched(TimePoint at) const {
  return views_ >= kLeastViews && at >= newest_ - kPause && at <= newest_ + kPause && !alarm_;
}

}  // namespace tripoint
