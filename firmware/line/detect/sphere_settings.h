// What counts as a red sphere that only reflects; [detector] with kind "sphere" in the configuration may change it.
#pragma once

namespace tripoint {

/// Red is a pixel whose colour is: V above grey by so much, by so much of its luma, and of a red hue.
///
/// Source of the defaults: ITU-R BT.601 for the colours. For the shape, half: a sphere that is lit from anywhere on the
/// camera's side, or straight from one side, shows at least half of its disc and half of its outline. Light at the
/// angle a from the line of sight leaves (1 + cos a)/2 of the disc lit and, for every a up to 90 degrees, half of the
/// outline on the circle; the rest ends inside it. The same half is what a holder or a highlight may take from a sphere
/// that is lit from the front. Towards 90 degrees the border of the light is too dim to be red: rendered spheres that
/// only one light shines on are found up to 75 degrees.
struct SphereSettings {
  double min_radius_px = 10.0;   ///< five samples of chroma
  double max_radius_px = 120.0;  ///< half the height of a 640x480 picture across
  double min_redness = 0.4;      ///< (V - 128) / Y: full red has 1.37, skin 0.15, red with 0.45 of green and blue 0.4
  double min_fill = 0.5;         ///< share of the circle's area that is red
  int min_red_step = 12;         ///< V above grey: one level of U or V then turns the hue by 5 degrees
  double max_hue = 0.6;          ///< -dU/dV: pure red has 0.34, orange 0.7 and more
  double min_hue = -0.2;         ///< magenta has less
  double min_outline = 0.5;      ///< share of the directions in which the edge lies on the circle
  /// Share of the directions in which the red ends beyond the circle: light, shadow and holders take from a sphere,
  /// only something else adds to it. A tenth is left for its reflection on what it lies on. A square has a quarter and
  /// more.
  double max_spill = 0.1;
  /// Standard deviation per axis of what the fit cannot see: where the sphere is dim, its edge is seen too far inside.
  /// Rendered spheres of 32 px radius err by less than 2.5 px with light from one side only, and by less than 0.4 px
  /// with light from the front; what the outline shows of it is stated on top.
  double floor_px = 0.5;
};

}  // namespace tripoint
