#include "sim/silhouette.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kPixelVariance_px2 = 1.0 / 12.0;
constexpr double kReachSigmas = 4.0;  // beyond it an edge covers less than 4e-5
constexpr double kEdgeOn = 1e-6;      // px^2 of picture for a figure of a square millimetre

/// d(pixel) / d(place on the figure, half axes).
Matrix2 px_from_half_axes(const Outline& outline, const CameraModel& camera, const Isometry3& camera_from_reference,
                          const Vec3& center_in_camera_mm) {
  const Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(Vec3(0.0, 0.0, -1.0), outline.facing);
  Eigen::Matrix<double, 3, 2> axes_mm;
  axes_mm.col(0) = outline.half_axes_mm.x() * Vec3(std::cos(outline.angle_rad), std::sin(outline.angle_rad), 0.0);
  axes_mm.col(1) = outline.half_axes_mm.y() * Vec3(-std::sin(outline.angle_rad), std::cos(outline.angle_rad), 0.0);
  return projection_jacobian_px_per_mm(camera, center_in_camera_mm) * camera_from_reference.linear() *
         upright.toRotationMatrix() * axes_mm;
}

/// A strip from -half_width to half_width, seen at a place across it.
double strip_share(double half_width_px, double place_px, double edge_sigma_px, const NormalIntegral& normal) {
  const auto upper = static_cast<float>((half_width_px - place_px) / edge_sigma_px);
  const auto lower = static_cast<float>((half_width_px + place_px) / edge_sigma_px);
  return std::max(static_cast<double>(normal(upper)) + static_cast<double>(normal(lower)) - 1.0, 0.0);
}

}  // namespace

std::optional<Silhouette> silhouette_of(const Outline& outline, const CameraModel& camera,
                                        const Isometry3& camera_from_reference, double blur_px) {
  const Vec3 center_in_camera_mm = camera_from_reference * outline.center_in_reference_mm;
  const Result<RawPixel> center = projected(camera, center_in_camera_mm);
  if (!center) return std::nullopt;
  const Matrix2 axes_px = px_from_half_axes(outline, camera, camera_from_reference, center_in_camera_mm);
  if (std::abs(axes_px.determinant()) < kEdgeOn * outline.half_axes_mm.prod()) return std::nullopt;
  const double edge_sigma_px = std::sqrt(blur_px * blur_px + kPixelVariance_px2);
  const Vec2 inner_px =
      outline.shape == Shape::kEllipse ? Vec2(axes_px.rowwise().norm()) : Vec2(axes_px.cwiseAbs().rowwise().sum());
  return Silhouette{.shape = outline.shape,
                    .center = *center,
                    .depth_mm = center_in_camera_mm.z(),
                    .half_axes_from_px = axes_px.inverse(),
                    .reach_px = inner_px.array() + kReachSigmas * edge_sigma_px,
                    .edge_sigma_px = edge_sigma_px};
}

double covered_share(const Silhouette& silhouette, double u_px, double v_px, const NormalIntegral& normal) {
  if (std::abs(u_px - silhouette.center.u_px) > silhouette.reach_px.x()) return 0.0;
  if (std::abs(v_px - silhouette.center.v_px) > silhouette.reach_px.y()) return 0.0;
  const Matrix2& scale = silhouette.half_axes_from_px;
  const Vec2 place = place_on(silhouette, u_px, v_px);
  if (silhouette.shape == Shape::kBox) {
    const Vec2 half_px = scale.rowwise().norm().cwiseInverse();
    return strip_share(half_px.x(), place.x() * half_px.x(), silhouette.edge_sigma_px, normal) *
           strip_share(half_px.y(), place.y() * half_px.y(), silhouette.edge_sigma_px, normal);
  }
  const double radius = std::max(place.norm(), 1e-9);                                   // the rim is at 1
  const double half_px = radius / std::max((scale.transpose() * place).norm(), 1e-12);  // first order at the rim
  return strip_share(half_px, radius * half_px, silhouette.edge_sigma_px, normal);
}

double passed_share(std::span<const Mask> masks, double u_px, double v_px, const NormalIntegral& normal) {
  double passed = 1.0;
  for (const Mask& mask : masks) {
    const double covered = covered_share(mask.silhouette, u_px, v_px, normal);
    passed *= mask.shows_inside ? covered : 1.0 - covered;
  }
  return passed;
}

}  // namespace tripoint
