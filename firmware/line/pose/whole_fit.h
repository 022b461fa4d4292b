// How well all points of a target fit one pose, counting whatever they err by together.
#pragma once

#include <cstddef>
#include <span>

#include "line/model.h"
#include "line/pose/body_pose.h"
#include "values/linear.h"
#include "values/result.h"

namespace tripoint {

struct WholeFit {
  Isometry3 rig_from_target = Isometry3::Identity();
  double chi2 = 0.0;  ///< 4 n - 6 degrees of freedom for n points, each with two pixels
};

/// Least chi-square of all pixels over the pose, by Gauss-Newton with damping (Levenberg & Marquardt). The covariance
/// holds the image points with the edges that neighbouring corners share, the target's points (one error in both
/// pictures), and what all points share: the calibration's covariance and the clocks. These last are unknowns beside
/// the pose, known beforehand as well as their covariance says, which gives the chi-square of the whole covariance
/// without its inverse.
///
/// @param points three or more, not on a line; corners of a tag one after the other
/// @return kBehindCamera   a point comes to lie behind a camera;  kNoConvergence  the iteration does not settle
///         kDegenerate     a covariance is not positive definite, or the points do not determine a pose
Result<WholeFit> whole_fit(std::span<const LocatedPoint> points, const LineModel& model, const Isometry3& start);

/// That chi-square at a pose where nothing was fitted, what all points share at its best.
///
/// @return kBehindCamera, kDegenerate  likewise
Result<double> whole_chi2(std::span<const LocatedPoint> points, const LineModel& model,
                          const Isometry3& rig_from_target);

/// The chi-square that the noise of `points` points exceeds once in 1,000 times, within 1 %.
///
/// Source: Wilson & Hilferty 1931, "The distribution of chi-square".
double most_chi2(std::size_t points);

}  // namespace tripoint
