// What one view of the target says of a camera that has turned since the calibration.
#pragma once

#include <optional>
#include <span>

#include "line/model.h"
#include "line/pose/body_pose.h"
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
/// calibration, of the clocks, of all edges of tags and of the points' places in the target would do to it, and what
/// was seen. These errors are the same from view to view, and no number of views averages them out.
inline constexpr int kMostTargetPlaces = static_cast<int>(kMaxTargetPoints * kTagCorners);
inline constexpr int kTurnColumn = 0;
inline constexpr int kCalibrationColumn = 3;
inline constexpr int kClockColumn = kCalibrationColumn + 24;  ///< one standard deviation along two directions a picture
inline constexpr int kEdgesColumn = kClockColumn + 4;         ///< all edges of tags moved inwards by a pixel
inline constexpr int kTargetColumn = kEdgesColumn + 1;        ///< LocatedPoint::index says which three
inline constexpr int kSeenColumn = kTargetColumn + 3 * kMostTargetPlaces;
inline constexpr int kTurnColumns = kSeenColumn + 1;
using TurnEquations = Eigen::Matrix<double, 3, kTurnColumns>;

struct TurnEvidence {
  TurnEquations equations = TurnEquations::Zero();
  Matrix3 place_by_turn_mm = Matrix3::Zero();  ///< per rad, in the middle of the target
  double side_error_mm = 0.0;                  ///< mean over the distances between points: measured less nominal
};

/// A turned camera shows in the points' epipolar distances and in the distances between them.
///
/// @param points  three or more, by `located_target`
/// @param start   a pose of the target near the best one
/// @return nothing when the iteration for the best pose does not settle, when time makes a point far more uncertain
///         than its picture does, as in a sharp turn of its path, or when no number comes out
std::optional<TurnEvidence> turn_evidence(std::span<const LocatedPoint> points, const Isometry3& start,
                                          const LineModel& model);

}  // namespace tripoint
