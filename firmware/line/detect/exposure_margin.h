// How far the exposure is from both of its ends, told by the luma of the dimmest and the brightest spot.
#pragma once

namespace tripoint {

/// Peak of a red LED in units of clip: 1 = its red channel just clips.
///
/// Inverts what a linear camera makes of a red LED: luma 16 to 235 (ITU-R BT.601), channels 1 : 0.06 : 0.03, each
/// clipped at 1. A camera with a display's gamma shows a dim LED brighter: below 1 up to a factor of 3 too much, from 2
/// to 10 up to a factor of 1.8 (rendered with such a tone). MJPEG of the whole byte: within 15 %.
///
/// @param luma  of the spot's brightest pixel, 0 to 255
/// @return 0 at luma 16 and below; 33.3 from luma 235 on, where all channels clip and nothing more can be told
double led_peak_from_luma(double luma);

/// Level of a grey surface in units of clip, in a linear camera with luma 16 to 235; not below 0.
double level_from_luma(double luma);

/// What luma a peak has, 16 to 235; the inverse of led_peak_from_luma.
double luma_from_led_peak(double peak);

/// Below it LEDs begin to be missed with the default settings. Rendered at 250 to 700 mm, all are found in YUYV from
/// 0.45 on, and in MJPEG where the luma reads as 0.47.
inline constexpr double kDimmestLedPeak = 0.5;
/// From it on all channels clip at luma 233 and the spot is marked as saturated.
inline constexpr double kBrightestLedPeak = 30.0;
/// The recommended exposure: red just clips, green and blue do not. Source: decision 0008.
inline constexpr double kRecommendedFrom = 1.0;
inline constexpr double kRecommendedTo = 3.0;

/// As factors of light: 1 = at the limit, below 1 = beyond it.
struct ExposureMargin {
  double above_dim = 0.0;       ///< peak of the dimmest spot over kDimmestLedPeak
  double below_clipping = 0.0;  ///< kBrightestLedPeak over the peak of the brightest spot
};

/// @param dimmest_luma, brightest_luma  of the dimmest and the brightest spot's brightest pixel
ExposureMargin exposure_margin(double dimmest_luma, double brightest_luma);

}  // namespace tripoint
