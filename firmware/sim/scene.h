// What the simulated cameras look at: a list of light sources and a list of surfaces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "values/linear.h"

namespace tripoint {

/// Red, green, blue in linear light; 1 is the level at which the sensor clips.
using LinearColor = std::array<double, 3>;

enum class Mount { kTarget, kReference };

/// A small lamp: a Gaussian core and a wider, weaker Gaussian halo around it.
///
/// Its energy in the picture falls with the square of the distance; `peak` is that of the core at
/// kPeakDistance_mm, before a pixel averages over its area.
struct LightSource {
  int id = 0;                          ///< of the target's point; 0 is a light that is no part of the target
  Mount mount = Mount::kTarget;        ///< which frame it moves with
  Vec3 place_mm = Vec3::Zero();        ///< in the frame of its mount
  double peak = 1.5;                   ///< times clip, in a channel of relative colour 1
  LinearColor color{1.0, 0.06, 0.03};  ///< relative response of the channels to a red LED
  double core_sigma_mm = 1.1;          ///< standard deviation of the core without the lens
  double halo_share = 0.02;            ///< peak of the halo over peak of the core
  double halo_widening = 4.0;          ///< standard deviation of the halo over that of the core
};
inline constexpr double kPeakDistance_mm = 400.0;

/// A round patch facing the cameras, at a place in the reference frame.
struct Disc {
  Vec3 center_in_reference_mm = Vec3::Zero();
  double radius_mm = 10.0;
};

/// Something that reflects; without an outline it fills the picture.
struct Surface {
  LinearColor reflectance{0.5, 0.5, 0.5};
  double texture = 0.1;  ///< relative amplitude of a gentle pattern
  double texture_period_px = 90.0;
  std::optional<Disc> outline = std::nullopt;
};

struct Scene {
  std::vector<LightSource> lights;
  std::vector<Surface> surfaces{Surface{}};  ///< painted in this order
  double white_level = 0.05;                 ///< of a white surface, in units of clip
};

/// LEDs with ids 1, 2, ... at these places of the target, before a textured grey wall.
Scene led_scene(const std::vector<Vec3>& places_in_target_mm, double peak = 1.5);

}  // namespace tripoint
