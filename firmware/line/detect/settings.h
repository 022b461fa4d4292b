// What counts as a red LED. Every default is a measured one; [detector] in the configuration may change it.
#pragma once

#include <algorithm>

namespace tripoint {

/// Strength is S = 3 Y + 4 V', V' being V interpolated in x: almost the red channel, and monotone also where V has a
/// hole because the core is clipped. Candidates are judged on S and measured on Y.
///
/// Source of the defaults: rendered stereo scenes with lamps, skin, orange and red objects; tuned on one range of
/// seeds and scored on another.
struct LedDetectorSettings {
  // Selection on the coarse map of V.
  int min_red = 139;         ///< of V: 11 above grey
  int ring_step = 8;         ///< V: a ring cell this much below the centre counts as dark
  int max_ring_cells = 8;    ///< of the 16 ring cells, how many may be as bright as the centre
  int max_candidates = 200;  ///< looked at in one picture; more are cut and reported
  // Gates.
  int min_peak = 780;                  ///< S: red at about a third of full scale; shared chroma dims small spots
  int falloff = 60;                    ///< S: how far a spot falls within 4 to 30 px
  int min_contrast = 45;               ///< S above the background
  double min_contrast_of_noise = 4.0;  ///< the same, in standard deviations of the background
  double max_crowding = 0.45;          ///< share of the surroundings that is bright too
  int min_red_step = 8;                ///< V of the peak above V of the surroundings
  double min_redness = 0.7;            ///< dV/dY over the flank: a red LED has about 1.7, a warm reflection 0.2 to 0.6
  double max_hue = 0.6;                ///< -dU/dV over the flank: rendered red LEDs have 0 to 0.5, orange 0.7 and more
  int min_over_surface = 45;   ///< S above what a red surface may show where white is as bright as in this picture;
                               ///< not asked for with `min_emission` below 0: then red surfaces are looked for
  double min_emission = 0.0;   ///< dY/dS over the spot: a red object on a lighter ground has about -0.1
  double max_aspect = 1.9;     ///< long over short axis
  double max_residual = 0.30;  ///< RMS of the fit over the amplitude
  /// The smallest LEDs, 0.8 mm at 800 mm through a lens of 0.6 px, are rendered with 1.1 px at 640x480. A red hot pixel
  /// behind the demosaicing has 0.75 px, and where JPEG leaves out its finest part up to 0.90.
  double min_sigma_px = 0.95;
  double min_sigma_small_px = 0.85;  ///< the same in pictures of up to 400 px: there the smallest LEDs have 0.90
  double max_sigma_px = 4.0;
  double max_sigma_of_width = 0.016;  ///< of the picture's width; the larger of the two limits holds: largest_sigma_px
  double weak_sigma_px = 0.10;        ///< of the centre measured on Y: above it S is measured instead of Y
  double weak_amplitude = 12.0;       ///< Y: below it S is measured instead of Y, and the spot is marked weak
  double min_amplitude = 20.0;        ///< S/4: below it the spot is refused
  // Measuring.
  int hide_above = 1100;  ///< S: such pixels are not measured, and those around them less; mosaic and chroma bend them
  int luma_clip = 233;    ///< Y: all three channels are clipped above; the spot is marked as saturated
  /// Rendered 640x480 frames with mosaic and 4:2:2 err by 0.015 to 0.04 px: there 0.04 is honest.
  double floor_px = 0.10;        ///< standard deviation per axis of what the fit cannot see: demosaicing, chroma, shape
  double split_floor_px = 0.15;  ///< more of it where only the top of a spot stands alone, or S was measured
};

/// The smallest sigma that a spot may have in a picture of this width, px.
inline double smallest_sigma_px(const LedDetectorSettings& settings, int width_px) {
  constexpr int kSmall_px = 400;
  return width_px <= kSmall_px ? settings.min_sigma_small_px : settings.min_sigma_px;
}

/// The largest sigma that a spot may have in a picture of this width, px.
inline double largest_sigma_px(const LedDetectorSettings& settings, int width_px) {
  return std::max(settings.max_sigma_px, settings.max_sigma_of_width * width_px);
}

}  // namespace tripoint
