#include "geometry/rays.h"

#include <cmath>

namespace tripoint {
namespace {

Result<Ray> ray_of(const Rig& rig, Side side, const RawPixel& pixel) {
  const Result<NormalizedPoint> at = undistorted(rig.cameras[side], pixel);
  if (!at) return tl::make_unexpected(at.error());
  const Isometry3 rig_from_camera = rig.camera_from_rig[side].inverse();
  const Vec3 direction_in_camera = Vec3{at->x, at->y, 1.0}.normalized();
  return Ray{*at, rig_from_camera.translation(), rig_from_camera.linear() * direction_in_camera};
}

}  // namespace

Result<PerSide<Ray>> rays_of(const Rig& rig, const PerSide<RawPixel>& pixels) {
  const Result<Ray> left = ray_of(rig, Side::kLeft, pixels.left);
  if (!left) return tl::make_unexpected(left.error());
  const Result<Ray> right = ray_of(rig, Side::kRight, pixels.right);
  if (!right) return tl::make_unexpected(right.error());
  return PerSide<Ray>{*left, *right};
}

double angle_between_rad(const PerSide<Ray>& rays) {
  const Vec3& left = rays.left.direction_in_rig;
  const Vec3& right = rays.right.direction_in_rig;
  return std::atan2(left.cross(right).norm(), left.dot(right));
}

Vec3 midpoint_in_rig_mm(const PerSide<Ray>& rays) {
  const Vec3& a = rays.left.direction_in_rig;
  const Vec3& b = rays.right.direction_in_rig;
  const Vec3 between = rays.right.center_in_rig_mm - rays.left.center_in_rig_mm;
  const Vec3 normal = a.cross(b);
  const double along_left = between.cross(b).dot(normal) / normal.squaredNorm();
  const double along_right = between.cross(a).dot(normal) / normal.squaredNorm();
  return 0.5 * (rays.left.center_in_rig_mm + along_left * a + rays.right.center_in_rig_mm + along_right * b);
}

bool in_front_of_both(const Rig& rig, const Vec3& point_in_rig_mm) {
  return (rig.camera_from_rig.left * point_in_rig_mm).z() > 0.0 &&
         (rig.camera_from_rig.right * point_in_rig_mm).z() > 0.0;
}

}  // namespace tripoint
