#include "explain/look.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tripoint {

void draw_kept(Canvas& canvas, CanvasPoint at, const EllipseShape& shape) {
  constexpr double kArm_px = 4.5;
  const std::array<Stroke, 3> strokes{Stroke{{at.x - kArm_px, at.y}, {at.x + kArm_px, at.y}},
                                      Stroke{{at.x, at.y - kArm_px}, {at.x, at.y + kArm_px}}, ellipse(at, shape)};
  canvas.draw(strokes, {kKeptColour, 1.5, kHalo_px});
}

void draw_dropped(Canvas& canvas, CanvasPoint at, double reach_px) {
  const std::array<Stroke, 1> strokes{rectangle({at.x - reach_px, at.y - reach_px, at.x + reach_px, at.y + reach_px})};
  canvas.draw(strokes, {kDroppedColour, 1.5, kHalo_px});
}

/// Source: the eigenvalues of a symmetric 2x2 matrix.
EllipseShape three_sigma(const Matrix2& covariance_px2, double scale) {
  const double mean = 0.5 * (covariance_px2(0, 0) + covariance_px2(1, 1));
  const double difference = 0.5 * (covariance_px2(0, 0) - covariance_px2(1, 1));
  const double spread = std::hypot(difference, covariance_px2(0, 1));
  return {3.0 * scale * std::sqrt(mean + spread), 3.0 * scale * std::sqrt(std::max(0.0, mean - spread)),
          0.5 * std::atan2(covariance_px2(0, 1), difference)};
}

Colour colour_of(const Finding& finding) { return finding.kept() ? kKeptColour : kDroppedColour; }

}  // namespace tripoint
