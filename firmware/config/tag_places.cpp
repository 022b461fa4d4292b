#include "config/tag_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tripoint {
namespace {

constexpr double kSameWay = 0.9;       // cosine between the normals: 26 degrees
constexpr double kBefore = 0.5;        // of the larger size
constexpr double kLeastAxis = 1e-6;    // of a cross product of unit vectors: shorter, they are parallel
constexpr double kRounding_mm = 1e-6;  // tags may touch

using Corners = std::array<Vec3, 4>;

/// Along two edges and across the tag.
struct Axes {
  Vec3 first = Vec3::UnitX();
  Vec3 second = Vec3::UnitY();
  Vec3 normal = Vec3::UnitZ();
};

Axes axes_of(const Corners& corners) {
  const Vec3 first = (corners[1] - corners[0]).normalized();
  const Vec3 second = (corners[3] - corners[0]).normalized();
  return {first, second, first.cross(second)};
}

struct Extent {
  double least = 0.0;
  double most = 0.0;
};

Extent along(const Vec3& axis, const Corners& corners) {
  const auto [least, most] =
      std::minmax({axis.dot(corners[0]), axis.dot(corners[1]), axis.dot(corners[2]), axis.dot(corners[3])});
  return {least, most};
}

bool parted_along(const Vec3& axis, const Corners& one, const Corners& other) {
  const Extent here = along(axis, one);
  const Extent there = along(axis, other);
  return here.most <= there.least + kRounding_mm || there.most <= here.least + kRounding_mm;
}

bool hides(const TargetFileTag& one, const Axes& one_axes, const TargetFileTag& other, const Axes& other_axes) {
  const double before_mm = std::abs((other.position_mm - one.position_mm).dot(one_axes.normal));
  return one_axes.normal.dot(other_axes.normal) > kSameWay &&
         before_mm < kBefore * std::max(one.size_mm, other.size_mm);
}

}  // namespace

Corners corners_mm(const TargetFileTag& tag) {
  const double angle_rad = tag.rotation_rad.norm();
  Matrix3 turn = Matrix3::Identity();
  if (angle_rad > 0.0) turn = Eigen::AngleAxisd(angle_rad, tag.rotation_rad / angle_rad).toRotationMatrix();
  const double half_mm = tag.size_mm / 2.0;
  const auto corner = [&](double x, double y) -> Vec3 {
    return tag.position_mm + turn * Vec3(x * half_mm, y * half_mm, 0.0);
  };
  return {corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)};
}

bool overlap(const TargetFileTag& one, const TargetFileTag& other) {
  const Corners here = corners_mm(one);
  const Corners there = corners_mm(other);
  const Axes a = axes_of(here);
  const Axes b = axes_of(there);
  std::vector<Vec3> parting{a.first, a.second, b.first, b.second};
  if (!hides(one, a, other, b)) {
    parting.push_back(a.normal);
    parting.push_back(b.normal);
    for (const Vec3& edge : {a.first, a.second}) {
      for (const Vec3& across : {b.first, b.second}) parting.emplace_back(edge.cross(across));
    }
  }
  return std::none_of(parting.begin(), parting.end(),
                      [&](const Vec3& axis) { return axis.norm() > kLeastAxis && parted_along(axis, here, there); });
}

double farthest_mm(const TargetFileTag& one, const TargetFileTag& other) {
  double farthest = 0.0;
  for (const Vec3& here : corners_mm(one)) {
    for (const Vec3& there : corners_mm(other)) farthest = std::max(farthest, (here - there).norm());
  }
  return farthest;
}

}  // namespace tripoint
