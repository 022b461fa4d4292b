// Red spheres as a camera sees them: rays through a pinhole, one far light, ambient light and a highlight.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/painter.h"
#include "line/detect/sphere_detector.h"
#include "values/linear.h"
#include "values/pixel.h"

namespace tripoint::test {

/// Without distortion; the axis meets the middle of the picture.
struct Pinhole {
  ImageSize size{640, 480};
  double focal_px = 800.0;

  [[nodiscard]] RawPixel pixel_of(const Vec3& point_mm) const;
};

/// Source: Lambert's law for the paint; Blinn 1977, "Models of light reflection", for the highlight.
struct Sphere {
  Vec3 center_mm{0.0, 0.0, 300.0};  ///< z along the axis
  double radius_mm = 12.0;
  bench::Color paint{0.7, 0.05, 0.05};
  Vec3 to_light{-0.3, -0.5, -1.0};  ///< any length
  double ambient = 0.15;            ///< of the light
  double highlight = 0.8;           ///< white, in units of clip
};

/// The half axis of its picture across the direction from the middle, px; the smaller one.
double short_half_axis_px(const Sphere& sphere, const Pinhole& camera);

/// Four by four rays in each pixel; what lies behind the edge is `ground`.
void add(bench::Painting& painting, const Sphere& sphere, const Pinhole& camera, double ground);

inline constexpr double kGround = 0.08;  ///< grey, in units of clip

bench::YuyvPicture picture_of(const std::vector<Sphere>& spheres, const Pinhole& camera = {}, std::uint32_t seed = 1);

/// With the noise of this seed.
bench::YuyvPicture developed(const bench::Painting& painting, std::uint32_t seed = 1);

/// What is said of each candidate of the last picture, in their order.
std::string causes(const SphereDetector& detector);

}  // namespace tripoint::test
