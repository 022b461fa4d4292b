// What lies around a spot, and what its flank looks like against it.
#pragma once

#include "line/detect/flood.h"
#include "line/detect/spot_window.h"

namespace tripoint {

/// Percentiles (of S to 4 steps) of the ring between 2 r + 1.5 and 2 r + 4.5 px around an area of radius r.
struct Surround {
  int pixels = 0;
  int strength = 0;         ///< 40th percentile of S
  int luma = 0;             ///< 40th percentile of Y
  int red = 0;              ///< median of V
  double crowding = 0.0;    ///< share of the ring above 40 % of the contrast
  double luma_noise = 0.0;  ///< standard deviations, from the 20th to the 80th percentile
  double strength_noise = 0.0;

  /// The 40th percentile and the standard deviation on the channel's scale.
  [[nodiscard]] double ground(Channel channel) const { return channel == Channel::kLuma ? luma : 0.25 * strength; }
  [[nodiscard]] double noise(Channel channel) const {
    return channel == Channel::kLuma ? luma_noise : 0.25 * strength_noise;
  }
};

/// Outer radius of that ring.
double surround_reach_px(const Area& area);

/// @return no pixels when less than 8 of the ring are in the picture
Surround surround_of(const SpotWindow& window, const Area& area, int peak);

/// 40th percentile of S along the border of a part, `SpotWindow::kOutside` when less than 8 pixels are in the picture.
int background_of(const SpotWindow& window, const SpotWindow::Part& part);

/// Redness dV/dY over the flank: 12 to 85 % of the contrast, and above the pattern of the ground.
double redness_of_flank(const SpotWindow& window, const Area& area, const Surround& around, int peak);

/// What the area that `flood` holds sends out, above its surroundings.
struct AreaLight {
  double emission = 0.0;    ///< dY/dS
  double parting_px = 0.0;  ///< from the middle of its luma to the middle of its red; infinite where it has no luma
};
AreaLight light_of_area(const SpotWindow& window, const Flood& flood, const Surround& around);

}  // namespace tripoint
