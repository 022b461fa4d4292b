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

/// The ground under a spot, as a wide ring around it shows it.
struct GroundPlane {
  Vec2 slope = Vec2::Zero();  ///< steps per column and row
  bool rough = false;         ///< a step in it, taken for a slope, could do more harm than a slope left in
  double grain = 0.0;         ///< standard deviation of pixels against their neighbours: noise without pattern
};

/// A plane by least squares through what lies within 4 standard deviations of the ground.
///
/// A Gaussian of width sigma and amplitude A fitted on level ground is displaced by 4 sigma^2 / A times the slope.
/// @param radius_px  of the spot at half contrast
GroundPlane ground_plane(const Picture& picture, const RawPixel& at, double radius_px, const Ground& ground);

/// How far from the nearest pixel that ring reaches.
int ground_reach_px(double radius_px);

}  // namespace tripoint
