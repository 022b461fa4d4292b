// What the simulated cameras look at: a list of light sources and a list of surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/chessboard.h"
#include "sim/printed_tag.h"
#include "values/linear.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// Red, green, blue in linear light; 1 is the level at which the sensor clips.
using LinearColor = std::array<double, 3>;

enum class Mount { kTarget, kReference };

enum class Shape : std::uint8_t { kEllipse, kBox };

/// A flat figure at a place in the reference frame.
struct Outline {
  Vec3 center_in_reference_mm = Vec3::Zero();
  Vec2 half_axes_mm{10.0, 10.0};
  Shape shape = Shape::kEllipse;
  double angle_rad = 0.0;       ///< of the first axis in the figure's plane; from x towards y when facing -z
  Vec3 facing{0.0, 0.0, -1.0};  ///< unit normal in the reference frame; the default looks at the cameras
};

/// To and fro along a line, as a highlight goes over a part that turns: place + reach sin(2 pi t / period + phase), t
/// since 1970.
struct Sway {
  Vec3 reach_mm = Vec3::Zero();
  Duration period{std::chrono::seconds{1}};
  double phase_rad = 0.0;
};

/// A small lamp, a highlight, or an image of one in a mirror: a Gaussian core, a wider, weaker Gaussian halo around it,
/// and a veil of stray light.
///
/// Its energy in the picture falls with the square of the distance; `peak` is that of the core at
/// kPeakDistance_mm, before a pixel averages over its area. What hides a share of the core weakens halo and veil by
/// that share: they are made in the lens, of the light that gets there.
struct LightSource {
  int id = 0;                          ///< of the target's point; 0 is a light that is no part of the target
  Mount mount = Mount::kTarget;        ///< which frame it moves with
  Vec3 place_mm = Vec3::Zero();        ///< in the frame of its mount
  double peak = 1.5;                   ///< times clip, in a channel of relative colour 1
  LinearColor color{1.0, 0.06, 0.03};  ///< relative response of the channels to a red LED
  double core_sigma_mm = 1.1;          ///< standard deviation of the core without the lens
  double halo_share = 0.02;            ///< peak of the halo over peak of the core
  double halo_widening = 4.0;          ///< standard deviation of the halo over that of the core
  double elongation = 1.0;             ///< long over short axis of core and halo; the product of both axes is kept
  double elongation_angle_rad = 0.0;   ///< of the long axis in the picture, from u towards v
  PerSide<double> gain{1.0, 1.0};      ///< of `peak` in each view: lamps are directed, highlights differ by the view
  double veil_share = 0.0;             ///< energy of the veil over that of the core
  double veil_of_width = 0.08;         ///< standard deviation of the veil over the picture's width
  std::optional<Sway> sway = std::nullopt;                ///< about its place, in the same frame; absent: at rest in it
  std::optional<std::size_t> switched_by = std::nullopt;  ///< line of the simulated LEDs; absent: always lit
  std::optional<Vec3> facing = std::nullopt;  ///< shines evenly into this half space alone; unit length, as `place_mm`
  std::optional<Outline> mirror = std::nullopt;  ///< seen in this mirror only, as far behind it as it is in front
};
inline constexpr double kPeakDistance_mm = 400.0;

/// Where a light is in the frame of its mount.
Vec3 place_mm_at(const LightSource& light, Duration since_1970);

/// The image of a light in a flat mirror: no part of the target, and weaker by the reflectance.
LightSource reflection_of(const LightSource& light, const Outline& mirror, double reflectance);

/// Something that reflects; without an outline it fills the picture. One with an outline hides what is behind it.
struct Surface {
  LinearColor reflectance{0.5, 0.5, 0.5};
  double texture = 0.1;             ///< relative amplitude of a gentle pattern
  double texture_period_px = 90.0;  ///< without an outline
  double texture_period_mm = 12.0;  ///< with an outline
  double shading = 0.0;             ///< share by which the rim of a figure is darker than its centre
  std::optional<Outline> outline = std::nullopt;
};

struct Scene {
  std::vector<LightSource> lights;
  std::vector<Surface> surfaces{Surface{}};  ///< painted in this order where they are equally far; the far ones first
  double white_level = 0.05;                 ///< of a white surface, in units of clip
  std::optional<Chessboard> board = std::nullopt;  ///< before all surfaces; lights are not hidden by it
  std::vector<PrintedTag> tags = {};               ///< of the target, before surfaces and board; they hide no light
};

/// LEDs with ids 1, 2, ... and lines 0, 1, ... at these places of the target, before a textured grey wall.
Scene led_scene(const std::vector<Vec3>& places_in_target_mm, double peak = 1.5);

/// Like the scene's first LED, or any where it has none; always lit, and at rest in the reference frame: no part of the
/// target.
LightSource fixed_lamp(const Scene& scene, const Vec3& place_in_reference_mm);

}  // namespace tripoint
