// What one view of the target says of a camera that has turned since the calibration.
#pragma once

#include <optional>

#include "line/match/match.h"
#include "line/model.h"
#include "values/forecast.h"
#include "values/linear.h"

namespace tripoint {

/// d(last six of RigParameters) / d(turn of the right camera about its own lens centre, rotation vector along its axes,
/// rad), by central differences.
Eigen::Matrix<double, 6, 3> calibration_by_turn(const StereoCalibration& calibration);

/// The covariance that the calibration states; of one that states none, that of such a turn by 1e-4 rad about each
/// axis.
RigCovariance covariance_or_usual(const LineModel& model);

/// Normal equations of such a turn, with the target's pose eliminated. Columns: the turn itself, what errors of the
/// calibration, of the clocks and of the points' places in the target would do to it, and what was seen. The last four
/// are the same from view to view, and no number of views averages them out.
inline constexpr int kTurnColumn = 0;
inline constexpr int kCalibrationColumn = 3;
inline constexpr int kClockColumn = kCalibrationColumn + 24;  ///< one standard deviation along two directions a picture
inline constexpr int kTargetColumn = kClockColumn + 4;
inline constexpr int kSeenColumn = kTargetColumn + 3 * static_cast<int>(kMaxTargetPoints);
using TurnEquations = Eigen::Matrix<double, 3, kSeenColumn + 1>;

struct TurnEvidence {
  TurnEquations equations = TurnEquations::Zero();
  Matrix3 place_by_turn_mm = Matrix3::Zero();  ///< per rad, in the middle of the target
  double side_error_mm = 0.0;                  ///< mean over the target's sides: measured less nominal
};

/// A turned camera shows in the points' epipolar distances and in the distances between them.
///
/// @param pairs the whole target, identified, in the order of its points, of which there are three or more
/// @return nothing when a pair's rays do not meet in front of both cameras, when time makes a point far more uncertain
///         than its picture does, as in a sharp turn of its path, or when no number comes out
std::optional<TurnEvidence> turn_evidence(const Pairs& pairs, const LineModel& model);

}  // namespace tripoint
