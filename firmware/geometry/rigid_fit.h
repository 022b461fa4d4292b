// The place and attitude of a rigid body from both pictures of its points.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "values/linear.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// Order of every pose's parameters: x y z (mm), rotation vector (rad) applied on the left, R = exp(w) R0.
using PoseParameters = Eigen::Matrix<double, 6, 1>;

/// A point of the body as both cameras see it.
struct BodyPoint {
  Vec3 in_body_mm = Vec3::Zero();
  double sigma_mm = 0.0;  ///< standard deviation of its place in the body, in every direction
  PerSide<MeasuredPixel> seen;
};

struct RigidFit {
  Isometry3 rig_from_body = Isometry3::Identity();
  Matrix6 covariance = Matrix6::Zero();  ///< of PoseParameters, from the pixels and the body's points
  double chi2 = 0.0;                     ///< 4 n - 6 degrees of freedom for n points
};

/// Axes of three points that do not lie on a line: x from the first to the second, y across the triangle, z in it, away
/// from the third; origin midway between the first two.
///
/// Source: the paper's Eq. 11 to 13, with y across x and the line from the third point to the origin.
Isometry3 three_point_frame(const Vec3& p1, const Vec3& p2, const Vec3& p3);

/// Which three of the points make the triangle of the largest area, in the order of the points.
///
/// @param points three or more
std::array<std::size_t, 3> widest_triangle(std::span<const Vec3> points);

/// Turns and moves by a small step of PoseParameters.
Isometry3 moved(const Isometry3& pose, const PoseParameters& step);

/// Least weighted squared reprojection error in both raw pictures, by Gauss-Newton. What a point is misplaced in the
/// body shows in both pictures alike, so its four pixel coordinates are weighted together.
///
/// @param start near the pose, with all points in front of both cameras
/// @return kBehindCamera   a point comes to lie behind a camera;  kNoConvergence  the iteration does not settle
///         kDegenerate     a covariance is not positive definite, or the points do not determine a pose: fewer than
///                         three, or on a line
Result<RigidFit> rigid_fit(const Rig& rig, std::span<const BodyPoint> points, const Isometry3& start);

}  // namespace tripoint
