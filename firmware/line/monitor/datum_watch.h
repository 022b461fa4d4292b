// Whether the fixed datum is seen where it belongs.
#pragma once

#include <chrono>
#include <optional>

#include "line/match/match.h"
#include "line/model.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

/// What is found stays news for so long after the newest view.
inline constexpr Duration kFindingShown = std::chrono::seconds(2);

/// A datum that is seen beside its place shows what a target alone never does: a turn of one camera also when the
/// target is a single LED, and both cameras that were moved together. Which it was cannot be told, nor whether somebody
/// moved the datum. It is an alarm when what the datum's spots, its own place and the calibration may be wrong by, each
/// as stated, hardly ever explains it. It ends when the datum is seen at its place, and no more where it was seen then.
class DatumWatch {
 public:
  /// One view of the datum, by a model that has one.
  void learn(const Pair& datum, TimePoint at, const LineModel& model);

  [[nodiscard]] bool alarm() const { return alarm_; }
  /// How far beside its place it is seen, mean over the newest views; absent when they are too few, or old at this
  /// time.
  [[nodiscard]] std::optional<double> moved_mm(TimePoint at) const;
  /// Whether it was seen up to this time, but for a few pictures, and is no alarm.
  [[nodiscard]] bool watched(TimePoint at) const;

  static constexpr int kLeastViews = 4;                               ///< before anything is judged
  static constexpr Duration kPause = std::chrono::milliseconds(300);  ///< without a view: watching begins anew

 private:
  using Offset = Eigen::Vector4d;  // left u v, right u v, of the datum's pixels less those of its place

  void judge();

  // Means of the newest views. The covariance is that of one: an LED that stands still errs alike in each.
  Offset offset_px_ = Offset::Zero();
  Eigen::Matrix4d covariance_px2_ = Eigen::Matrix4d::Zero();
  Vec3 moved_mm_ = Vec3::Zero();
  int views_ = 0;  // in the mean, no more than it remembers
  TimePoint newest_{};
  bool alarm_ = false;
  double alarm_chi2_ = 0.0;  // the largest since it was raised, and the offset that it spoke for
  Offset alarm_offset_px_ = Offset::Zero();
};

}  // namespace tripoint
