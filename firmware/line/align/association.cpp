#include "line/align/association.h"

#include <algorithm>
#include <limits>

namespace tripoint {
namespace {

constexpr double kRunnerUpFactor = 2.0;
constexpr double kRunnerUpMargin_px = 2.0;  // spots closer than that cannot be told apart between pictures

struct Nearest {
  std::size_t index = 0;
  double distance_px = std::numeric_limits<double>::infinity();
  double runner_up_px = std::numeric_limits<double>::infinity();
};

Nearest nearest(const Vec2& point, std::span<const Vec2> others) {
  Nearest best;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double distance_px = (others[i] - point).norm();
    if (distance_px < best.distance_px) {
      best.runner_up_px = best.distance_px;
      best.distance_px = distance_px;
      best.index = i;
    } else if (distance_px < best.runner_up_px) {
      best.runner_up_px = distance_px;
    }
  }
  return best;
}

bool is_close_call(const Nearest& found, double gate_px) {
  return found.runner_up_px < gate_px && found.runner_up_px < kRunnerUpFactor * found.distance_px + kRunnerUpMargin_px;
}

}  // namespace

FixedVector<Link, kMaxImagePoints> linked(std::span<const Vec2> expected, std::span<const Vec2> now, double gate_px) {
  FixedVector<Link, kMaxImagePoints> links;
  for (std::size_t i = 0; i < now.size(); ++i) {
    Link link;
    const Nearest before = nearest(now[i], expected);
    if (before.distance_px < gate_px) {
      const Nearest back = nearest(expected[before.index], now);
      link.ambiguous = is_close_call(before, gate_px) || is_close_call(back, gate_px);
      if (!link.ambiguous && back.index == i) link.before = before.index;
    }
    links.push_back(link);
  }
  return links;
}

FixedVector<Link, kMaxImagePoints> linked_by_label(std::span<const ImagePoint> before, std::span<const Vec2> expected,
                                                   std::span<const ImagePoint> now, double gate_px) {
  FixedVector<Link, kMaxImagePoints> links;
  for (const ImagePoint& point : now) {
    const auto same = [&](const ImagePoint& other) { return other.label == point.label; };
    const auto first = std::find_if(before.begin(), before.end(), same);
    Link link;
    if (first != before.end()) {
      const auto index = static_cast<std::size_t>(first - before.begin());
      link.ambiguous = std::count_if(now.begin(), now.end(), same) > 1 ||
                       std::find_if(first + 1, before.end(), same) != before.end();
      const bool near = (Vec2(point.at.u_px, point.at.v_px) - expected[index]).norm() < gate_px;
      if (near && !link.ambiguous) link.before = index;
    }
    links.push_back(link);
  }
  return links;
}

}  // namespace tripoint
