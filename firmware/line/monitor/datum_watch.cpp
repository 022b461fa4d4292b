#include "line/monitor/datum_watch.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "geometry/triangulation.h"
#include "line/monitor/turn_evidence.h"
#include "line/pose/pixel_rows.h"

namespace tripoint {
namespace {

constexpr int kMemory = 10;  // views: a third of a second
// Chi-square with four degrees of freedom: above once in 800,000 units, and in 5,000.
constexpr double kAlarm = 33.0;
constexpr double kExcluded = 22.0;

struct View {
  Eigen::Vector4d offset_px = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance_px2 = Eigen::Matrix4d::Zero();
  Vec3 moved_mm = Vec3::Zero();  ///< where it seems to be, to first order
};

/// Nothing when its place lies behind a camera or no number comes out.
std::optional<View> view_of(const Pair& datum, const LineModel& model) {
  const Vec3& in_rig_mm = model.datum->in_rig_mm;
  View view;
  Eigen::Matrix4d weight = Eigen::Matrix4d::Zero();
  for (const Side side : kBothSides) {
    const AlignedPoint& point = datum.points[side];
    const Result<RawPixel> there = projected(model.rig.cameras[side], model.rig.camera_from_rig[side] * in_rig_mm);
    if (!there) return std::nullopt;
    const Eigen::Index row = first_row(side);
    view.offset_px.segment<2>(row) << point.seen.at.u_px - there->u_px, point.seen.at.v_px - there->v_px;
    // At rest an LED errs alike in the two pictures that its place lies between: no more is known than from one.
    view.covariance_px2.block<2, 2>(row, row) = point.seen.covariance_px2 / point.averaging;
    weight.block<2, 2>(row, row) = view.covariance_px2.block<2, 2>(row, row).inverse();
  }
  const Eigen::Matrix<double, kPixels, 3> by_place = pixels_by_place(model.rig, in_rig_mm);
  const Eigen::Matrix<double, 3, kPixels> weighted = by_place.transpose() * weight;
  view.moved_mm = Eigen::LLT<Matrix3>(weighted * by_place).solve(weighted * view.offset_px);

  const auto by_calibration = pixels_by_calibration(model.calibration, in_rig_mm);
  const Eigen::Matrix<double, kPixels, 24> calibration = by_calibration.lazyProduct(covariance_or_usual(model));
  const double own_mm = model.datum->uncertainty_mm / 2.0;
  view.covariance_px2 += calibration.lazyProduct(by_calibration.transpose());
  view.covariance_px2 += own_mm * own_mm * by_place * by_place.transpose();
  if (!view.moved_mm.allFinite() || !view.covariance_px2.allFinite()) return std::nullopt;
  return view;
}

}  // namespace

void DatumWatch::learn(const Pair& datum, TimePoint at, const LineModel& model) {
  const std::optional<View> view = view_of(datum, model);
  if (!view) return;
  if (at > newest_ + kPause) views_ = 0;  // a datum that shows now and then says little of now
  newest_ = at;
  views_ = std::min(views_ + 1, kMemory);
  offset_px_ += (view->offset_px - offset_px_) / views_;
  covariance_px2_ += (view->covariance_px2 - covariance_px2_) / views_;
  moved_mm_ += (view->moved_mm - moved_mm_) / views_;
  if (views_ >= kLeastViews) judge();
}

void DatumWatch::judge() {
  const Eigen::LDLT<Eigen::Matrix4d> covariance(covariance_px2_);
  const auto chi2 = [&](const Offset& explained) -> double {
    const Offset unexplained = offset_px_ - explained;
    return unexplained.dot(covariance.solve(unexplained));
  };
  const double without = chi2(Offset::Zero());
  if (without > std::max(kAlarm, alarm_ ? alarm_chi2_ : 0.0)) {
    alarm_ = true;
    alarm_chi2_ = without;
    alarm_offset_px_ = offset_px_;
  } else if (alarm_ && without < kExcluded && chi2(alarm_offset_px_) > kExcluded) {
    alarm_ = false;
  }
}

std::optional<double> DatumWatch::moved_mm(TimePoint at) const {
  if (views_ < kLeastViews || at > newest_ + kFindingShown) return std::nullopt;
  return moved_mm_.norm();
}

bool DatumWatch::watched(TimePoint at) const {
  return views_ >= kLeastViews && at >= newest_ - kPause && at <= newest_ + kPause && !alarm_;
}

}  // namespace tripoint
