// Every place the detector looked at, and why it was kept or dropped.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "values/fixed_vector.h"
#include "values/pixel.h"

namespace tripoint {

enum class DropCause : std::uint8_t {
  kKept,
  kSeenBefore,    ///< the same spot, reached from another cell
  kDim,           ///< peak below `needed_peak`
  kNoFalloff,     ///< as bright all around: a surface, not a spot
  kNoContrast,    ///< hardly above its background
  kTooLarge,      ///< reaches the border of the largest window: a surface or a halo over 40 px
  kTooSmall,      ///< a single pixel
  kElongated,     ///< aspect: a cable, an edge, a reflection, two merged spots
  kNoSurround,    ///< too close to the border to know its surroundings
  kCrowded,       ///< the surroundings are bright too
  kNotRedder,     ///< not redder than its surroundings
  kNotRed,        ///< the flank is white or warm, not red
  kNotEmitting,   ///< a red thing that reflects, not one that shines
  kTwoLights,     ///< the middle of its light lies elsewhere than that of its red
  kFitFailed,     ///< too few visible pixels, or the fit left the spot
  kPoorFit,       ///< not a Gaussian: partly hidden, merged, or a patch with a flat top
  kWrongSize,     ///< sigma out of range
  kWeak,          ///< amplitude below `min_amplitude`
  kCutByBorder,   ///< the picture ends inside the spot
  kWrongProfile,  ///< sigma and area contradict each other
  kOtherHue,      ///< red by orange light: more green in it than a red LED has
  kRedSurface,    ///< no stronger than a red surface in the light of this picture may be
  kNoRoom,        ///< the list of points is full
  kBeyondBand,    ///< what had to be looked at was not all decoded
  // Of spheres.
  kOtherRadius,    ///< radius out of range
  kHiddenOutline,  ///< too little of the edge lies on one circle: not round, or partly hidden
  kNotFilled,      ///< too little of the circle is red
  kSprawling,      ///< the red area goes on beyond the circle: overlapping spheres, or a larger thing
};
inline constexpr std::array<std::string_view, 28> kDropCauseNames{
    "kept",        "seen_before", "dim",         "no_falloff",   "no_contrast",    "too_large",     "too_small",
    "elongated",   "no_surround", "crowded",     "not_redder",   "not_red",        "not_emitting",  "two_lights",
    "fit_failed",  "poor_fit",    "wrong_size",  "weak",         "cut_by_border",  "wrong_profile", "other_hue",
    "red_surface", "no_room",     "beyond_band", "other_radius", "hidden_outline", "not_filled",    "sprawling"};

constexpr std::string_view name(DropCause cause) { return kDropCauseNames[static_cast<std::size_t>(cause)]; }

/// A whole pixel of the picture.
struct PixelPlace {
  int u_px = 0;
  int v_px = 0;
};

/// What was measured at one place, as far as the gates let it come; later fields stay 0.
struct Candidate {
  DropCause cause = DropCause::kKept;
  int start_u_px = 0;  ///< the pixel at which looking began
  int start_v_px = 0;
  RawPixel at;                   ///< the best known place: start, centre of the area, or the fit's centre
  float peak = 0.0F;             ///< S
  float needed_peak = 0.0F;      ///< the same, at least
  float contrast = 0.0F;         ///< S above the background
  float needed_contrast = 0.0F;  ///< the same, at least
  float level = 0.0F;            ///< of the contrast, at which the spot stood alone
  float radius_px = 0.0F;        ///< of the circle with the spot's area at that level
  float aspect = 0.0F;
  float crowding = 0.0F;
  float red_step = 0.0F;      ///< V
  float surround_red = 0.0F;  ///< V
  float redness = 0.0F;       ///< dV/dY
  float emission = 0.0F;      ///< dY/dS
  float parting_px = 0.0F;    ///< from the middle of its luma to the middle of its red
  float sigma_px = 0.0F;
  float amplitude = 0.0F;    ///< luma steps, of the brightest visible pixel
  float residual = 0.0F;     ///< of the amplitude
  float misfit = 0.0F;       ///< what of the residual the grain of the surroundings does not explain, of the amplitude
  int hidden_pixels = 0;     ///< clipped, and left out of the fit
  float hue = 0.0F;          ///< -dU/dV
  float outline = 0.0F;      ///< share of the directions in which the edge lies on the circle
  float fill = 0.0F;         ///< share of the circle's area that is red
  float spill = 0.0F;        ///< share of the directions in which the red ends beyond the circle
  float red_surface = 0.0F;  ///< S that a red surface in the light of the picture may have
};

/// From the middle of a spot's light to that of its red.
inline float most_parting_px(float radius_px) { return std::max(1.0F, 0.5F * radius_px); }

/// Room for every candidate and for a second look beside each accepted one.
inline constexpr std::size_t kMaxCandidates = 256;
using CandidateLog = FixedVector<Candidate, kMaxCandidates>;

}  // namespace tripoint
