// Whether the cameras still stand as they were calibrated, as far as the target shows it.
#pragma once

#include <chrono>
#include <optional>
#include <span>

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/monitor/datum_watch.h"
#include "line/monitor/turn_evidence.h"
#include "line/monitor/view_noise.h"
#include "line/pose/pose.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

/// A knocked camera makes poses wrong that look right: what it turns about the vertical moves no point off its epipolar
/// line. So the turn of the right camera against the left is estimated from epipolar distances and the target's sides
/// together, over about the last second in which the whole target or some of its tags were seen. It is an alarm when
/// noise, calibration and target, each as uncertain as stated, hardly ever explain it. It ends when the target shows
/// that the turn which raised it is no more: not for want of evidence. A target of one or two LEDs shows too little,
/// and watches nothing. A datum, if there is one, watches beside any target.
///
/// A target that no longer fits the calibration is looked for by one that may have turned by a tenth of a degree; what
/// it finds is evidence, never a pose.
class Decalibration {
 public:
  /// Begins anew, unless it is still about the same cameras, target and datum.
  void watch(const LineModel& model);

  void learn(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model);

  /// The measurement with side-length error, estimate (the larger of what target and datum show) and whether the mount
  /// is watched, while they are news, and during an alarm of either with kDecalibration in place of a pose, its points
  /// without identity.
  [[nodiscard]] Measurement judged(Measurement measurement) const;

  /// Evidence is taken no closer in time: nearer verdicts share pictures.
  static constexpr Duration kLeastApart = std::chrono::milliseconds(30);

 private:
  struct Findings {
    TurnEquations sums = TurnEquations::Zero();
    ViewNoise noise;                          ///< of the sums
    double clock_sigmas = 0.0;                ///< sum of what the clocks may have done to each view
    Matrix3 clock_spreads = Matrix3::Zero();  ///< likewise: squares over what clock_sigmas adds up
    int views = 0;                            ///< in the sums, no more than they remember
    TimePoint newest{};
    double side_error_mm = 0.0;
    double moved_mm = 0.0;
    bool alarm = false;
    double alarm_chi2 = 0.0;  ///< the largest since it was raised, and the turn that it spoke for
    Vec3 alarm_turn_rad = Vec3::Zero();
  };

  void take(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model);
  void add(const TurnEvidence& evidence, std::span<const LocatedPoint> points, TimePoint at);
  [[nodiscard]] Matrix3 spread_without_turn(const LineModel& model) const;
  void judge(const LineModel& model, const Matrix3& place_by_turn_mm);

  LineModel turned_;  // the model, less sure of how the cameras are turned
  Findings found_;
  DatumWatch datum_;
  TimePoint searched_{};  // for a target that no longer fits
};

}  // namespace tripoint
