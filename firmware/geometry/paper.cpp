#include "geometry/paper.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "geometry/rays.h"

namespace tripoint {
namespace {

constexpr double kVirtualFocalMm = 1.0;  // any length will do: it cancels
constexpr double kLeastDepthShare = 1e-6;
constexpr double kParallelRad = 1e-12;  // less moves a point by less than rounding does

/// A camera turned about its lens centre into the paper's model.
struct VirtualCamera {
  double angle_rad = 0.0;
  Vec3 center_in_rig_mm = Vec3::Zero();
  Matrix3 turned_from_rig = Matrix3::Identity();
  Matrix3 turned_from_camera = Matrix3::Identity();
};

/// The paper's Eq. 4, corrected: camera coordinates to common coordinates.
Matrix3 rotation_about_y(double angle_rad) { return Eigen::AngleAxisd{angle_rad, Vec3::UnitY()}.toRotationMatrix(); }

VirtualCamera virtual_camera(const Rig& rig, Side side) {
  const Isometry3 rig_from_camera = rig.camera_from_rig[side].inverse();
  const Vec3 axis_in_rig = rig_from_camera.linear().col(2);
  const double towards_other = side == Side::kLeft ? axis_in_rig.x() : -axis_in_rig.x();
  const double angle = std::atan2(towards_other, axis_in_rig.z());
  const Matrix3 turned_from_rig = rotation_about_y(side == Side::kLeft ? angle : -angle).transpose();
  return {angle, rig_from_camera.translation(), turned_from_rig, turned_from_rig * rig_from_camera.linear()};
}

/// What Eq. 7 needs of a camera: its picture of a direction, and offsets that put its lens centre in place.
PaperCamera paper_camera(Side side, const VirtualCamera& camera, const Vec3& direction_in_turned) {
  const double focal = kVirtualFocalMm;
  const Vec3& center = camera.center_in_rig_mm;
  const double away_from_other = side == Side::kLeft ? -center.x() : center.x();
  const Vec3 offset{away_from_other + focal * std::sin(camera.angle_rad), -center.y(),
                    focal * std::cos(camera.angle_rad) - center.z()};
  return {focal, camera.angle_rad, offset, -focal * direction_in_turned.head<2>() / direction_in_turned.z()};
}

/// d(x/z, y/z)/d(x, y, z)
Matrix23 perspective_jacobian(const Vec3& point) {
  Matrix23 jacobian;
  jacobian << 1.0 / point.z(), 0.0, -point.x() / (point.z() * point.z()),  //
      0.0, 1.0 / point.z(), -point.y() / (point.z() * point.z());
  return jacobian;
}

/// Covariance of a raw pixel, carried into the turned camera's plane z = 1.
Matrix2 covariance_in_turned(const CameraModel& camera, const NormalizedPoint& at, const VirtualCamera& turned,
                             const Matrix2& covariance_px2) {
  const Vec3 direction = turned.turned_from_camera * Vec3{at.x, at.y, 1.0};
  const Matrix2 by_pixel = perspective_jacobian(direction) * turned.turned_from_camera.leftCols<2>() *
                           distortion_jacobian_px(camera, at).inverse();
  return by_pixel * covariance_px2 * by_pixel.transpose();
}

/// The point fulfils u1 = const, v1 = const, u2 = const: their gradients, inverted, carry the covariance.
Matrix3 covariance_of(const Rig& rig, const PerSide<Ray>& rays, const PerSide<MeasuredPixel>& seen, const Vec3& point) {
  const PerSide<VirtualCamera> turned{virtual_camera(rig, Side::kLeft), virtual_camera(rig, Side::kRight)};
  Matrix3 image_by_point;
  Matrix3 image_covariance = Matrix3::Zero();
  const auto gradient = [&](Side side) -> Matrix23 {
    const Vec3 point_in_turned = turned[side].turned_from_rig * (point - turned[side].center_in_rig_mm);
    return perspective_jacobian(point_in_turned) * turned[side].turned_from_rig;
  };
  image_by_point.topRows<2>() = gradient(Side::kLeft);
  image_by_point.bottomRows<1>() = gradient(Side::kRight).topRows<1>();
  image_covariance.topLeftCorner<2, 2>() =
      covariance_in_turned(rig.cameras.left, rays.left.at, turned.left, seen.left.covariance_px2);
  image_covariance(2, 2) =
      covariance_in_turned(rig.cameras.right, rays.right.at, turned.right, seen.right.covariance_px2)(0, 0);
  const Matrix3 point_by_image = image_by_point.inverse();
  return point_by_image * image_covariance * point_by_image.transpose();
}

/// Lens centres on the rig's x axis and axes along z: the geometry of Eq. 10.
bool is_parallel(const PerSide<VirtualCamera>& turned) {
  return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
    return std::abs(turned[side].angle_rad) < kParallelRad &&
           turned[side].center_in_rig_mm.tail<2>().norm() < kParallelRad * turned[side].center_in_rig_mm.norm();
  });
}

/// Eq. 10, whose frame has its origin midway between the picture planes, in the rig.
Result<Vec3> point_of_parallel(const PerSide<VirtualCamera>& turned, const PerSide<PaperCamera>& cameras) {
  const PerSide<Vec3> centers{turned.left.center_in_rig_mm, turned.right.center_in_rig_mm};
  const Vec3 lens_in_paper{0.0, 0.0, kVirtualFocalMm};
  return point_by_equation_10(
             {kVirtualFocalMm, centers.right.x() - centers.left.x(), {cameras.left.image, cameras.right.image}})
      .map([&](const Vec3& point) -> Vec3 { return point - lens_in_paper + 0.5 * (centers.left + centers.right); });
}

Result<Vec3> point_of_rays(const Rig& rig, const PerSide<Ray>& rays, double min_angle_rad) {
  const PerSide<VirtualCamera> turned{virtual_camera(rig, Side::kLeft), virtual_camera(rig, Side::kRight)};
  PerSide<PaperCamera> cameras;
  for (const Side side : kBothSides) {
    const Vec3 direction = turned[side].turned_from_rig * rays[side].direction_in_rig;
    if (!(direction.z() > kLeastDepthShare)) return failure(ErrorCode::kDegenerate);
    cameras[side] = paper_camera(side, turned[side], direction);
  }
  return is_parallel(turned) ? point_of_parallel(turned, cameras) : point_by_equation_7(cameras, min_angle_rad);
}

Vec2 reprojection_error_px(const Rig& rig, Side side, const RawPixel& seen, const Vec3& point_in_rig) {
  const Vec3 point_in_camera = rig.camera_from_rig[side] * point_in_rig;
  const RawPixel predicted = distorted(
      rig.cameras[side], {point_in_camera.x() / point_in_camera.z(), point_in_camera.y() / point_in_camera.z()});
  return {seen.u_px - predicted.u_px, seen.v_px - predicted.v_px};
}

}  // namespace

Result<Vec3> point_by_equation_7(const PerSide<PaperCamera>& cameras, double min_angle_rad) {
  const PaperCamera& one = cameras.left;
  const PaperCamera& two = cameras.right;
  const double s1 = std::sin(one.angle_rad);
  const double c1 = std::cos(one.angle_rad);
  const double s2 = std::sin(two.angle_rad);
  const double c2 = std::cos(two.angle_rad);
  const double u1 = one.image.x();
  const double u2 = two.image.x();
  const double m1 = one.focal * c1 + u1 * s1;
  const double m2 = two.focal * c2 - u2 * s2;
  const double n1 = u1 * c1 - one.focal * s1;
  const double n2 = u2 * c2 + two.focal * s2;
  const double meeting = m1 * n2 - m2 * n1;
  const double length1 = std::hypot(m1, n1);
  if (!(std::abs(meeting) > std::sin(min_angle_rad) * length1 * std::hypot(m2, n2))) {
    return failure(ErrorCode::kRaysAlmostParallel);
  }
  if (!(std::abs(m1) > kLeastDepthShare * length1)) return failure(ErrorCode::kDegenerate);

  const Vec3& o1 = one.offset;
  const Vec3& o2 = two.offset;
  const double z =
      (m1 * m2 * (o1.x() + o2.x()) + m1 * two.focal * u2 - m2 * one.focal * u1 + m2 * n1 * o1.z() - m1 * n2 * o2.z()) /
      meeting;
  const double x = (u1 * one.focal - m1 * o1.x() - n1 * (z + o1.z())) / m1;
  const double v1 = one.image.y();
  const double y = v1 - o1.y() - v1 / one.focal * ((x + o1.x()) * s1 + (z + o1.z()) * c1);
  return Vec3{x, y, z};
}

Result<Vec3> point_by_equation_10(const ParallelPair& pair) {
  const Vec2& one = pair.image.left;
  const double disparity = one.x() - pair.image.right.x();
  if (!(std::abs(disparity) > 0.0)) return failure(ErrorCode::kRaysAlmostParallel);
  const double z = pair.focal - pair.baseline * pair.focal / disparity;
  const double scale = (pair.focal - z) / pair.focal;
  return Vec3{scale * one.x() - 0.5 * pair.baseline, scale * one.y(), z};
}

Result<TriangulatedPoint> triangulated_by_paper(const Rig& rig, const PerSide<MeasuredPixel>& seen,
                                                double min_angle_rad) {
  const Result<PerSide<Ray>> rays = rays_of(rig, {seen.left.at, seen.right.at});
  if (!rays) return tl::make_unexpected(rays.error());
  if (!(std::sin(angle_between_rad(*rays)) > std::sin(min_angle_rad))) return failure(ErrorCode::kRaysAlmostParallel);
  const Result<Vec3> point = point_of_rays(rig, *rays, 0.0);
  if (!point) return tl::make_unexpected(point.error());
  if (!in_front_of_both(rig, *point)) return failure(ErrorCode::kBehindCamera);
  const Result<EpipolarError> epipolar = epipolar_error(rig, seen);
  if (!epipolar) return tl::make_unexpected(epipolar.error());

  TriangulatedPoint result{*point, covariance_of(rig, *rays, seen, *point), 0.0, {}};
  result.chi2 = epipolar->distance_px * epipolar->distance_px / epipolar->variance_px2;
  result.residual_px.left = reprojection_error_px(rig, Side::kLeft, seen.left.at, *point);
  result.residual_px.right = reprojection_error_px(rig, Side::kRight, seen.right.at, *point);
  return result;
}

}  // namespace tripoint
