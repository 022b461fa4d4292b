// How a flat figure appears in one picture: its edge, softened as the lens and the pixels soften it.
#pragma once

#include <optional>
#include <span>

#include "geometry/camera_model.h"
#include "sim/normal_integral.h"
#include "sim/scene.h"

namespace tripoint {

/// The picture of an outline, to first order around its centre: parallax and foreshortening are right, the bending
/// of its edge by the lens is not drawn.
struct Silhouette {
  Shape shape = Shape::kEllipse;
  RawPixel center;
  double depth_mm = 0.0;  ///< of the centre, along the optical axis
  Matrix2 half_axes_from_px = Matrix2::Identity();
  Vec2 reach_px = Vec2::Zero();  ///< half width and half height of the rectangle outside which nothing is covered
  double edge_sigma_px = 1.0;    ///< the edge is a step seen through this blur
};

/// @param blur_px  standard deviation of the lens's blur; the pixel's own width is added
/// @return nothing when the centre is not in front of the camera, or the figure is seen edge-on
std::optional<Silhouette> silhouette_of(const Outline& outline, const CameraModel& camera,
                                        const Isometry3& camera_from_reference, double blur_px);

/// A pixel's place on the figure, in units of its half axes.
inline Vec2 place_on(const Silhouette& silhouette, double u_px, double v_px) {
  return silhouette.half_axes_from_px * Vec2(u_px - silhouette.center.u_px, v_px - silhouette.center.v_px);
}

/// Share of a pixel's light that the figure covers.
double covered_share(const Silhouette& silhouette, double u_px, double v_px, const NormalIntegral& normal);

/// What lets through a share of the light behind it: a figure hides, a mirror shows only what is within it.
struct Mask {
  Silhouette silhouette;
  bool shows_inside = false;
};

/// Share of the light from behind all masks that reaches a pixel.
double passed_share(std::span<const Mask> masks, double u_px, double v_px, const NormalIntegral& normal);

}  // namespace tripoint
