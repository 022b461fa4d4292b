// The circle through points of an outline, of which some belong to something else.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "values/linear.h"
#include "values/pixel.h"

namespace tripoint {

inline constexpr std::size_t kOutlineDirections = 96;  ///< a point every 4.6 px on a radius of 70

struct CircleFit {
  RawPixel center;
  double radius_px = 0.0;
  Matrix2 covariance_px2 = Matrix2::Identity();  ///< of the centre, from the scatter of the points on the circle
  double residual_px = 0.0;                      ///< RMS distance of those points from it
  std::size_t on_circle = 0;                     ///< how many points lie on it
  std::size_t beyond = 0;                        ///< how many lie outside it
};

/// The circle with most agreement, then weighted least squares of the distances from it. On it is what lies within 1 px
/// and 3 % of the radius: a sphere 20 degrees beside the axis is an ellipse, 3 % to either side of a circle. The
/// scatter counts for as many points as are independent: those 3 px apart, and fewer when neighbours err alike.
///
/// @param points  in the order of their directions, at most kOutlineDirections
/// @param largest_px  circles of a larger radius are not tried: on a huge one everything would lie
/// @return nothing when no circle has more than a third of the points and at least 8
/// Source: Torr & Zisserman 2000, "MLESAC" (agreement instead of a count), over fixed triples; Gander, Golub & Strebel
/// 1994, "Least-squares fitting of circles and ellipses" (geometric fit by Gauss-Newton); Beaton & Tukey 1974
/// (weights); Bayley & Hammersley 1946, "The effective number of independent observations" (1 - r)/(1 + r) of them.
std::optional<CircleFit> fitted_circle(std::span<const Vec2> points, double largest_px);

}  // namespace tripoint
