#include "rendered_sphere.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace tripoint::test {
namespace {

constexpr int kRays = 4;
constexpr double kShininess = 40.0;
constexpr double kOnlyThisPixel_px = 0.4;

double middle_u_px(const Pinhole& camera) { return 0.5 * (camera.size.width_px - 1); }
double middle_v_px(const Pinhole& camera) { return 0.5 * (camera.size.height_px - 1); }

/// Where a ray from the camera meets the sphere first.
std::optional<Vec3> first_hit_mm(const Sphere& sphere, const Vec3& ray) {
  const double along_mm = ray.dot(sphere.center_mm);
  const double square_mm2 = along_mm * along_mm - sphere.center_mm.squaredNorm() + sphere.radius_mm * sphere.radius_mm;
  if (square_mm2 < 0.0) return std::nullopt;
  return ray * (along_mm - std::sqrt(square_mm2));
}

bench::Color color_at(const Sphere& sphere, const Vec3& ray, const Vec3& hit_mm) {
  const Vec3 normal = (hit_mm - sphere.center_mm) / sphere.radius_mm;
  const Vec3 light = sphere.to_light.normalized();
  const double lit = std::max(0.0, normal.dot(light));
  const double mirrored = std::max(0.0, normal.dot((light - ray).normalized()));
  const double white = lit > 0.0 ? sphere.highlight * std::pow(mirrored, kShininess) : 0.0;
  bench::Color color{};
  for (std::size_t c = 0; c < color.size(); ++c) color[c] = sphere.paint[c] * (sphere.ambient + lit) + white;
  return color;
}

/// Nothing where no ray of the pixel meets the sphere.
std::optional<bench::Color> mean_over_pixel(const Sphere& sphere, const Pinhole& camera, const RawPixel& pixel,
                                            double ground) {
  bench::Color sum{};
  int hits = 0;
  for (int i = 0; i < kRays * kRays; ++i) {
    const double x_px = pixel.u_px + (i % kRays + 0.5) / kRays - 0.5 - middle_u_px(camera);
    const double y_px = pixel.v_px + (i / kRays + 0.5) / kRays - 0.5 - middle_v_px(camera);
    const Vec3 ray = Vec3(x_px, y_px, camera.focal_px).normalized();
    const std::optional<Vec3> hit_mm = first_hit_mm(sphere, ray);
    const bench::Color color = hit_mm ? color_at(sphere, ray, *hit_mm) : bench::Color{ground, ground, ground};
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += color[c] / (kRays * kRays);
    hits += hit_mm ? 1 : 0;
  }
  return hits > 0 ? std::optional<bench::Color>(sum) : std::nullopt;
}

}  // namespace

RawPixel Pinhole::pixel_of(const Vec3& point_mm) const {
  return {middle_u_px(*this) + focal_px * point_mm.x() / point_mm.z(),
          middle_v_px(*this) + focal_px * point_mm.y() / point_mm.z()};
}

double short_half_axis_px(const Sphere& sphere, const Pinhole& camera) {
  const double depth_mm = sphere.center_mm.z();
  return camera.focal_px * sphere.radius_mm / std::sqrt(depth_mm * depth_mm - sphere.radius_mm * sphere.radius_mm);
}

void add(bench::Painting& painting, const Sphere& sphere, const Pinhole& camera, double ground) {
  const RawPixel at = camera.pixel_of(sphere.center_mm);
  const double reach_px = 1.6 * short_half_axis_px(sphere, camera) + 2.0;
  const int bottom = std::min(camera.size.height_px - 1, static_cast<int>(at.v_px + reach_px));
  const int right = std::min(camera.size.width_px - 1, static_cast<int>(at.u_px + reach_px));
  for (int v = std::max(0, static_cast<int>(at.v_px - reach_px)); v <= bottom; ++v) {
    for (int u = std::max(0, static_cast<int>(at.u_px - reach_px)); u <= right; ++u) {
      const RawPixel pixel{static_cast<double>(u), static_cast<double>(v)};
      if (const auto color = mean_over_pixel(sphere, camera, pixel, ground)) {
        painting.add(bench::Ellipse{
            .at = pixel, .half_width_px = kOnlyThisPixel_px, .half_height_px = kOnlyThisPixel_px, .color = *color});
      }
    }
  }
}

bench::YuyvPicture developed(const bench::Painting& painting, std::uint32_t seed) {
  std::mt19937 random(seed);
  return painting.develop({}, random);
}

bench::YuyvPicture picture_of(const std::vector<Sphere>& spheres, const Pinhole& camera, std::uint32_t seed) {
  bench::Painting painting(camera.size, kGround);
  for (const Sphere& sphere : spheres) add(painting, sphere, camera, kGround);
  return developed(painting, seed);
}

std::string causes(const SphereDetector& detector) {
  std::string text;
  for (const Candidate& candidate : detector.candidates()) text += std::string(name(candidate.cause)) + " ";
  return text;
}

}  // namespace tripoint::test
