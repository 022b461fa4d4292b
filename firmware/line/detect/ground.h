// The slope of the ground that a spot stands on: under a spot it would pass for a shift of the centre.
#pragma once

#include "ports/frame.h"
#include "values/linear.h"

namespace tripoint {

/// What is known of the luma around a spot.
struct Ground {
  double luma = 0.0;
  double noise = 0.0;  ///< standard deviation
};

/// By how many steps the luma rises per column and row in a wide ring around a spot: a plane by least squares through
/// what lies within 4 standard deviations of the ground.
///
/// A Gaussian of width sigma and amplitude A fitted on level ground is displaced by 4 sigma^2 / A times the slope.
/// @param radius_px  of the spot at half contrast
/// @return zero where the ground is rough: a step in it, taken for a slope, would do more harm than a slope left in
Vec2 ground_slope(const Picture& picture, const RawPixel& at, double radius_px, const Ground& ground);

}  // namespace tripoint
