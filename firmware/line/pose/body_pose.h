// The full pose of a target from three or more of its points.
#pragma once

#include <optional>
#include <span>

#include "geometry/triangulation.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/pose/timing_part.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint {

/// One identified point of the target as measured.
struct LocatedPoint {
  TargetPoint of;
  PerSide<MeasuredPixel> pixels;
  TriangulatedPoint place;                                         ///< by the model's method
  PerSide<Matrix32> by_pixel{Matrix32::Zero(), Matrix32::Zero()};  ///< how the place follows the pixels
  Eigen::Matrix<double, 3, 24> place_by_calibration = Eigen::Matrix<double, 3, 24>::Zero();
  Eigen::Matrix<double, 3, 4> moved_by_clocks_mm = Eigen::Matrix<double, 3, 4>::Zero();  ///< see pose_of_body
  PerSide<Matrix2> clocks_root_px{Matrix2::Zero(), Matrix2::Zero()};  ///< timing_root_px of each picture
  double averaging = 1.0;           ///< AlignedPoint's, the smaller one of both image points
  std::size_t index = 0;            ///< by `located_target`: among the target's LEDs, or the corners of its tags
  std::optional<std::size_t> next;  ///< of a tag's corner: which of the points is the next one, with the same edge
  PerSide<Matrix2> shared_with_next_px2{Matrix2::Zero(), Matrix2::Zero()};
  std::optional<Vec3> moved_by_skew_mm;  ///< if the skew were taken as none; absent while the speed is unknown
};

struct BodyPose {
  TargetPose in_output;
  Isometry3 rig_from_target = Isometry3::Identity();
  double timing_sigma_mm = 0.0;  ///< of the position, all directions together
  std::optional<double> uncorrected_cost_mm;
};

/// By maximum likelihood the rigid fit of all points' pixels; by the paper's method the frame of the
/// three that make the widest triangle.
///
/// The clocks' error is one for all points, so what it moves them by (`moved_by_clocks_mm`, standard deviations along
/// two directions of each picture, each column of the same sign in all points) adds up, whereas the noise does not.
/// The calibration's part is of first order: how the pose follows its points, and they the parameters.
///
/// @param points three or more, not on a line
/// @return as rigid_fit; kNoConvergence also when a point lies elsewhere than the pose says
Result<BodyPose> pose_of_body(std::span<const LocatedPoint> points, const LineModel& model);

/// The same, the rigid fit starting elsewhere than at `pose_of_widest_triangle`.
Result<BodyPose> pose_of_body(std::span<const LocatedPoint> points, const LineModel& model, const Isometry3& start);

/// Rig from target by three of the points alone.
Isometry3 pose_of_widest_triangle(std::span<const LocatedPoint> points);

}  // namespace tripoint
