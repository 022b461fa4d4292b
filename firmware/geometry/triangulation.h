// From two image points to one point in space, with its uncertainty.
#pragma once

#include "geometry/rig.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// A measured image point with the covariance of its place.
struct MeasuredPixel {
  RawPixel at;
  Matrix2 covariance_px2 = Matrix2::Identity();
};

struct TriangulatedPoint {
  Vec3 in_rig_mm = Vec3::Zero();
  Matrix3 covariance_mm2 = Matrix3::Zero();  ///< from the image points' covariance alone
  double chi2 = 0.0;                         ///< weighted squared residual; one degree of freedom
  PerSide<Vec2> residual_px{Vec2::Zero(), Vec2::Zero()};
};

/// Maximum-likelihood point: least weighted squared reprojection error in both raw pictures, by Gauss-Newton
/// from the midpoint of the rays.
///
/// @return kNoConvergence       a pixel cannot be undistorted or the iteration does not settle
///         kRaysAlmostParallel  the rays meet at less than `min_angle_rad`
///         kBehindCamera        the best point lies behind a camera
///         kDegenerate          a covariance is not positive definite
/// Source: Hartley & Sturm 1997, "Triangulation".
Result<TriangulatedPoint> triangulated(const Rig& rig, const PerSide<MeasuredPixel>& seen, double min_angle_rad = 0.01);

/// How far two pixels are from sharing an epipolar plane: the Sampson distance in the raw pictures. With equal
/// and round covariances distance^2 / variance is the chi2 of `triangulated` to first order.
/// Source: Hartley & Zisserman 2004, "Multiple View Geometry", eq. 11.9.
struct EpipolarError {
  double distance_px = 0.0;   ///< signed, first order, both pictures' shares together
  double variance_px2 = 0.0;  ///< of distance_px
};

/// @return kNoConvergence when a pixel cannot be undistorted; kDegenerate when both look along the baseline
Result<EpipolarError> epipolar_error(const Rig& rig, const PerSide<MeasuredPixel>& seen);

/// d(point in rig, mm) / d(calibration parameters) at a measured point: how a calibration error moves it.
/// The rig frame moves with the parameters, as the definition of the reference frame says. Implicit
/// differentiation at the point of least error, terms of the size of the residual left out; the camera's part is
/// closed form, the six of right_from_left are central differences of the predicted pixels (steps 1e-5 rad,
/// 1e-3 mm: relative error below 1e-8). The calibration must have a rig, and the pixels must triangulate.
Eigen::Matrix<double, 3, 24> calibration_jacobian(const StereoCalibration& calibration,
                                                  const PerSide<MeasuredPixel>& seen);

/// d(left u v, right u v; px) / d(calibration parameters) for a point that stays where it is in the rig. How and how
/// exactly as for calibration_jacobian. The calibration must have a rig, and the point lie in front of both cameras.
Eigen::Matrix<double, 4, 24> pixels_by_calibration(const StereoCalibration& calibration, const Vec3& point_in_rig_mm);

}  // namespace tripoint
