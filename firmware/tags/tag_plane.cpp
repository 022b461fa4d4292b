#include "tags/tag_plane.h"

namespace tripoint {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

/// Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping", 2.2.3: of a square from 0 to 1, then of ours.
TagPlane::TagPlane(const std::array<Vec2, kTagCorners>& corners_px) {
  const auto& [lower_left, lower_right, upper_right, upper_left] = corners_px;
  const Vec2 right = upper_right - lower_right;
  const Vec2 below = lower_left - lower_right;
  const Vec2 skew = upper_left - upper_right + lower_right - lower_left;
  const double area = cross(right, below);
  const double g = cross(skew, below) / area;
  const double h = cross(right, skew) / area;
  const Vec3 along_x((upper_right - upper_left + g * upper_right).x(), (upper_right - upper_left + g * upper_right).y(),
                     g);
  const Vec3 along_y((lower_left - upper_left + h * lower_left).x(), (lower_left - upper_left + h * lower_left).y(), h);
  const Vec3 origin(upper_left.x(), upper_left.y(), 1.0);
  pixels_from_tag_ << 0.5 * along_x, 0.5 * along_y, origin + 0.5 * along_x + 0.5 * along_y;
}

TagPlane::Place TagPlane::at(const Vec2& place) const {
  const Vec3 homogeneous = pixels_from_tag_ * place.homogeneous();
  const Vec2 at_px = homogeneous.hnormalized();
  return {at_px,
          (pixels_from_tag_.topLeftCorner<2, 2>() - at_px * pixels_from_tag_.row(2).head<2>()) / homogeneous.z()};
}

}  // namespace tripoint
