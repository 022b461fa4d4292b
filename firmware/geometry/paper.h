// The paper's closed-form triangulation, corrected, in its own geometry and for any calibrated rig.
#pragma once

#include "geometry/rig.h"
#include "geometry/triangulation.h"
#include "values/linear.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// One camera of the paper's model: picture plane at local z = 0, lens centre at z = +focal, picture inverted
/// (u and v positive where upright pixels are negative). One unit of length throughout, never mixed with px.
struct PaperCamera {
  double focal = 1.0;
  double angle_rad = 0.0;      ///< the axis leans towards the other camera, about y
  Vec3 offset = Vec3::Zero();  ///< X0, Y0, Z0 of the paper; X0 positive for both cameras
  Vec2 image = Vec2::Zero();   ///< u, v
};

/// Point by the paper's Eq. 7 and 8 in the order Z, X, Y; Y comes from camera 1 (left) alone.
///
/// @return kRaysAlmostParallel when, seen along y, the rays meet at no more than `min_angle_rad`;
///         kDegenerate when ray 1 runs across z (the paper's m1 = 0)
/// Source: the paper's Eq. 1, 4, 5, 7, 8; sign of sin b in 4 and order and signs in 1, 5, 7 corrected.
Result<Vec3> point_by_equation_7(const PerSide<PaperCamera>& cameras, double min_angle_rad = 1e-9);

/// Point by the paper's Eq. 10 for parallel axes: X = (F - Z) u1/F - B/2, Y = (F - Z) v1/F, Z = F - B F/(u1 - u2).
///
/// @return kRaysAlmostParallel when u1 = u2
/// Source: the paper's Eq. 9, 10, restored.
struct ParallelPair {
  double focal = 1.0;
  double baseline = 1.0;
  PerSide<Vec2> image{Vec2::Zero(), Vec2::Zero()};  ///< inverted, as in PaperCamera
};
Result<Vec3> point_by_equation_10(const ParallelPair& pair);

/// The paper's method for any rig: the pixels are undistorted, and each camera is turned about its own lens centre
/// (a homography of its picture, exact) until its axis lies in the rig's x-z plane without roll, which is the paper's
/// model. Parallel axes give the point by Eq. 10. Otherwise it is Eq. 7 and 8: what remains of an axis is its angle,
/// the offsets put the lens centres where the rig has them.
///
/// @return the point with its covariance by first-order propagation; chi2 is the squared epipolar error in
///         standard deviations, residual_px the reprojection errors (left is zero but for rounding, as Y comes from it)
///         kNoConvergence       a pixel cannot be undistorted
///         kRaysAlmostParallel  the rays meet at less than `min_angle_rad`, or do so when seen along y
///         kBehindCamera        the point lies behind a camera
///         kDegenerate          a ray does not cross the turned camera's picture plane
Result<TriangulatedPoint> triangulated_by_paper(const Rig& rig, const PerSide<MeasuredPixel>& seen,
                                                double min_angle_rad = 0.01);

}  // namespace tripoint
