#include "config/target_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tripoint {
namespace {

using Triple = std::array<std::size_t, 3>;
using Points = std::span<const Vec3>;

double side(Points points, std::size_t a, std::size_t b) { return (points[a] - points[b]).norm(); }

double longest_side(Points points) {
  double longest = 0.0;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) longest = std::max(longest, side(points, a, b));
  }
  return longest;
}

/// Calls `take` with each three different points, in each of their orders.
template <typename Take>
void for_each_triple(std::size_t points, Take take) {
  for (std::size_t a = 0; a < points; ++a) {
    for (std::size_t b = 0; b < points; ++b) {
      for (std::size_t c = 0; c < points; ++c) {
        if (a != b && b != c && a != c) take(Triple{a, b, c});
      }
    }
  }
}

double twice_area(Points points, const Triple& t) {
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
}

Triple widest_triple(Points points) {
  Triple widest{0, 1, 2};
  for_each_triple(points.size(), [&](const Triple& t) {
    if (twice_area(points, t) > twice_area(points, widest)) widest = t;
  });
  return widest;
}

bool is_line(Points points) {
  const double longest = longest_side(points);
  return twice_area(points, widest_triple(points)) < kLeastWidthShare * longest * longest;
}

bool congruent(Points points, const Triple& from, const Triple& to) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (std::abs(side(points, from[k], from[next]) - side(points, to[k], to[next])) >= kAlike_mm) return false;
  }
  return true;
}

/// x along the first side, z across the triangle, origin in its middle.
Isometry3 frame_of(Points points, const Triple& t) {
  Isometry3 frame = Isometry3::Identity();
  const Vec3 x = (points[t[1]] - points[t[0]]).normalized();
  const Vec3 z = x.cross(points[t[2]] - points[t[0]]).normalized();
  frame.linear() << x, z.cross(x), z;
  frame.translation() = (points[t[0]] + points[t[1]] + points[t[2]]) / 3.0;
  return frame;
}

/// For each point the one that it comes to lie on when the target is turned so that `from` lies on `to`; nothing when
/// one of them lies on none.
std::optional<std::vector<std::size_t>> turned(Points points, const Triple& from, const Triple& to) {
  const Isometry3 turn = frame_of(points, to) * frame_of(points, from).inverse();
  std::vector<std::size_t> lies_on(points.size());
  for (std::size_t k = 0; k < 3; ++k) lies_on[from[k]] = to[k];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::find(from.begin(), from.end(), i) != from.end()) continue;
    const Vec3 there = turn * points[i];
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - there).norm() < (b - there).norm();
    });
    if ((*nearest - there).norm() >= kAlike_mm) return std::nullopt;
    lies_on[i] = static_cast<std::size_t>(nearest - points.begin());
  }
  return lies_on;
}

/// A way to turn the target onto itself, other than not at all. Three points of it say how it is turned.
std::optional<std::vector<std::size_t>> turned_onto_itself(Points points) {
  const Triple from = widest_triple(points);
  std::optional<std::vector<std::size_t>> found;
  for_each_triple(points.size(), [&](const Triple& to) {
    if (found || to == from || !congruent(points, from, to)) return;
    found = turned(points, from, to);
  });
  return found;
}

bool serves(Points points) {
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (side(points, a, b) < kAlike_mm) return false;
    }
  }
  return !is_line(points) && !turned_onto_itself(points);
}

/// In the plane of the target, as far as it has one: along the line from one point to another, and across it.
std::vector<Vec3> directions(Points points, const std::optional<Vec3>& facing) {
  const Triple widest = widest_triple(points);
  const Vec3 along = points[widest[1]] - points[widest[0]];
  Vec3 across_plane =
      is_line(points) ? facing.value_or(Vec3::UnitZ()) : along.cross(points[widest[2]] - points[widest[0]]);
  if (across_plane.cross(along).norm() < 1e-3 * along.norm()) across_plane = along.unitOrthogonal();
  std::vector<Vec3> all;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < points.size(); ++b) {
      if (a == b) continue;
      all.emplace_back((points[b] - points[a]).normalized());
      all.emplace_back(across_plane.cross(points[b] - points[a]).normalized());
    }
  }
  return all;
}

Vec3 to_tenths(const Vec3& place_mm) {
  Vec3 rounded = (10.0 * place_mm).array().round() / 10.0;
  return rounded + Vec3::Zero();  // no -0
}

/// The shortest of the moves tried that makes the target serve.
std::string remedy(Points points, const std::optional<Vec3>& facing) {
  constexpr double kStepShare = 0.05;  // of the longest side
  constexpr int kSteps = 8;
  const std::vector<Vec3> ways = directions(points, facing);
  const double step_mm = std::max(kStepShare * longest_side(points), kAlike_mm);
  std::vector<Vec3> moved(points.begin(), points.end());
  for (int steps = 1; steps <= kSteps; ++steps) {
    for (std::size_t i = points.size(); i-- > 0;) {  // the first is often the origin
      for (const Vec3& way : ways) {
        moved[i] = to_tenths(points[i] + steps * step_mm * way);
        if (serves(moved)) {
          return fmt::format("move points[{}] to [{:.1f}, {:.1f}, {:.1f}]", i, moved[i].x(), moved[i].y(),
                             moved[i].z());
        }
      }
      moved[i] = points[i];
    }
  }
  return "no move of one point alone mends it: choose other places";
}

std::string name_of_symmetry(Points points, const std::vector<std::size_t>& lies_on) {
  if (points.size() == 3) {
    const std::array<double, 3> sides{side(points, 0, 1), side(points, 1, 2), side(points, 2, 0)};
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    return fmt::format("{} triangle (sides {:.1f}, {:.1f}, {:.1f} mm, equal if they differ by less than {} mm)",
                       *most - *least < kAlike_mm ? "an equilateral" : "an isosceles", sides[0], sides[1], sides[2],
                       kAlike_mm);
  }
  std::size_t first = 0;
  while (lies_on[first] == first) ++first;
  return fmt::format("turned, they lie on themselves within {} mm, points[{}] where points[{}] is", kAlike_mm, first,
                     lies_on[first]);
}

}  // namespace

bool nearly_on_a_line(std::span<const Vec3> points_mm) { return points_mm.size() < 3 || is_line(points_mm); }

std::optional<std::string> shape_fault(std::span<const Vec3> points_mm, const std::optional<Vec3>& facing) {
  if (points_mm.size() < 3) return std::nullopt;
  std::string fault;
  if (is_line(points_mm)) {
    fault = fmt::format(
        "nearly on a line: how far they are turned about it cannot be seen; permitted is a width "
        "of {:.0f} % of the length or more",
        100.0 * kLeastWidthShare);
  } else if (const auto lies_on = turned_onto_itself(points_mm)) {
    fault = name_of_symmetry(points_mm, *lies_on) + ": which LED is which cannot be seen";
  } else {
    return std::nullopt;
  }
  return fmt::format("{}; {}", fault, remedy(points_mm, facing));
}

}  // namespace tripoint
