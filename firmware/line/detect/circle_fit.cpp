#include "line/detect/circle_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tripoint {
namespace {

constexpr double kOnCircle_px = 1.0;
constexpr double kOnCircleOfRadius = 0.03;
constexpr std::size_t kLeastOnCircle = 8;
constexpr int kSteps = 30;
constexpr double kSettled_px = 1e-10;
constexpr double kWeightEnds = 1.5;     ///< tolerances from the circle where a point has no say left
constexpr double kCorrelated_px = 3.0;  ///< along the outline: nearer points share their chroma
constexpr double kUnknowns = 3.0;

struct Circle {
  Vec2 center_px = Vec2::Zero();
  double radius_px = 0.0;

  [[nodiscard]] double distance_px(const Vec2& point) const { return (point - center_px).norm() - radius_px; }
  [[nodiscard]] double tolerance_px() const { return kOnCircle_px + kOnCircleOfRadius * radius_px; }
  [[nodiscard]] bool holds(const Vec2& point) const { return std::abs(distance_px(point)) <= tolerance_px(); }
  /// Tukey's biweight: falls from 1 to 0 without a step, so that no point that comes or goes holds the fit back.
  [[nodiscard]] double weight(const Vec2& point) const {
    const double share = distance_px(point) / (kWeightEnds * tolerance_px());
    return share * share < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
  }
};

std::optional<Circle> circle_through(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 along = b - a;
  const Vec2 across = c - a;
  const double twice_area = along.x() * across.y() - along.y() * across.x();
  if (std::abs(twice_area) < 1.0) return std::nullopt;  // px^2: nearly on a line
  const Vec2 from_a = Vec2(across.y() * along.squaredNorm() - along.y() * across.squaredNorm(),
                           along.x() * across.squaredNorm() - across.x() * along.squaredNorm()) /
                      (2.0 * twice_area);
  return Circle{.center_px = a + from_a, .radius_px = from_a.norm()};
}

std::size_t count_beyond(const Circle& circle, std::span<const Vec2> points) {
  const auto beyond = [&](const Vec2& point) { return circle.distance_px(point) > circle.tolerance_px(); };
  return static_cast<std::size_t>(std::ranges::count_if(points, beyond));
}

std::size_t count_on(const Circle& circle, std::span<const Vec2> points) {
  return static_cast<std::size_t>(std::ranges::count_if(points, [&](const Vec2& p) { return circle.holds(p); }));
}

double agreement(const Circle& circle, std::span<const Vec2> points) {
  return std::accumulate(points.begin(), points.end(), 0.0,
                         [&](double sum, const Vec2& point) { return sum + circle.weight(point); });
}

/// Triples of every direction with three spreads: one part of the outline may be something else, all together.
std::optional<Circle> most_agreed(std::span<const Vec2> points, double largest_px) {
  const std::size_t n = points.size();
  std::optional<Circle> best;
  double most = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t spread : {n / 3, n / 5, n / 8}) {
      const auto circle = circle_through(points[i], points[(i + spread) % n], points[(i + 2 * spread) % n]);
      const double agreed = circle && circle->radius_px <= largest_px ? agreement(*circle, points) : 0.0;
      if (agreed <= most) continue;
      most = agreed;
      best = circle;
    }
  }
  return best;
}

struct Normal {
  Matrix3 matrix = Matrix3::Zero();
  Vec3 right = Vec3::Zero();
  double squares_px2 = 0.0;
  double weights = 0.0;
};

Normal normal_equations(const Circle& circle, std::span<const Vec2> points) {
  Normal normal;
  for (const Vec2& point : points) {
    const double weight = circle.weight(point);
    if (weight <= 0.0) continue;
    const double distance_px = circle.distance_px(point);
    const Vec2 outwards = (point - circle.center_px).normalized();
    const Vec3 row(outwards.x(), outwards.y(), 1.0);
    normal.matrix += weight * row * row.transpose();
    normal.right += weight * row * distance_px;
    normal.squares_px2 += weight * distance_px * distance_px;
    normal.weights += weight;
  }
  return normal;
}

/// Gauss-Newton; nothing when it runs away.
std::optional<Circle> refined(Circle circle, std::span<const Vec2> points, double largest_px) {
  for (int step = 0; step < kSteps; ++step) {
    const Normal normal = normal_equations(circle, points);
    const Vec3 change = normal.matrix.ldlt().solve(normal.right);
    if (!change.allFinite()) return std::nullopt;
    circle.center_px += change.head<2>();
    circle.radius_px += change.z();
    if (!(circle.radius_px > 0.0) || circle.radius_px > largest_px) return std::nullopt;
    if (change.norm() < kSettled_px) break;
  }
  return circle;
}

/// Correlation of the distances of neighbours: near 1 where the outline is no circle, as of an ellipse or a shadow.
double correlation(const Circle& circle, std::span<const Vec2> points) {
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& next = points[(i + 1) % points.size()];
    if (!circle.holds(points[i]) || !circle.holds(next)) continue;
    const double one_px = circle.distance_px(points[i]);
    const double other_px = circle.distance_px(next);
    products += one_px * other_px;
    squares += 0.5 * (one_px * one_px + other_px * other_px);
  }
  return squares > 0.0 ? std::clamp(products / squares, 0.0, 1.0) : 0.0;
}

/// How many points tell as much as these, which are correlated along the outline.
double independent_points(const Circle& circle, std::span<const Vec2> points, double on) {
  const double arc_px = 2.0 * std::numbers::pi * circle.radius_px * on / static_cast<double>(points.size());
  const double alike = correlation(circle, points);
  const double of_correlation = on * (1.0 - alike) / (1.0 + alike);
  return std::clamp(std::min(arc_px / kCorrelated_px, of_correlation), kUnknowns + 1.0, on);
}

}  // namespace

std::optional<CircleFit> fitted_circle(std::span<const Vec2> points, double largest_px) {
  if (points.size() < kLeastOnCircle) return std::nullopt;
  const std::optional<Circle> start = most_agreed(points, largest_px);
  const std::optional<Circle> circle = start ? refined(*start, points, largest_px) : std::nullopt;
  if (!circle) return std::nullopt;
  const std::size_t on = count_on(*circle, points);
  if (on < kLeastOnCircle || 3 * on <= points.size()) return std::nullopt;
  const Normal normal = normal_equations(*circle, points);
  const double independent = independent_points(*circle, points, static_cast<double>(on));
  const double variance_px2 = normal.squares_px2 / (independent - kUnknowns);
  const Matrix3 covariance = variance_px2 * normal.matrix.inverse();
  if (!covariance.allFinite()) return std::nullopt;
  return CircleFit{.center = {circle->center_px.x(), circle->center_px.y()},
                   .radius_px = circle->radius_px,
                   .covariance_px2 = covariance.topLeftCorner<2, 2>(),
                   .residual_px = std::sqrt(normal.squares_px2 / normal.weights),
                   .on_circle = on,
                   .beyond = count_beyond(*circle, points)};
}

}  // namespace tripoint
