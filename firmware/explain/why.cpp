#include "explain/why.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

namespace tripoint {
namespace {

/// A gate that holds one measured value against one limit.
struct Comparison {
  DropCause cause = DropCause::kKept;
  std::string_view what;
  float Candidate::*measured = nullptr;
  double limit = 0.0;
  int decimals = 0;
};

std::array<Comparison, 12> comparisons_of(const LedDetectorSettings& settings, const Candidate& candidate) {
  const double surface = static_cast<double>(candidate.red_surface) + settings.min_over_surface;
  return {
      {{DropCause::kDim, "peak", &Candidate::peak, static_cast<double>(candidate.needed_peak), 0},
       {DropCause::kNoContrast, "contrast", &Candidate::contrast, static_cast<double>(candidate.needed_contrast), 0},
       {DropCause::kElongated, "aspect", &Candidate::aspect, settings.max_aspect, 2},
       {DropCause::kCrowded, "bright around", &Candidate::crowding, settings.max_crowding, 2},
       {DropCause::kNotRedder, "red step", &Candidate::red_step, static_cast<double>(settings.min_red_step), 0},
       {DropCause::kNotRed, "redness", &Candidate::redness, settings.min_redness, 2},
       {DropCause::kNotEmitting, "emission", &Candidate::emission, settings.min_emission, 2},
       {DropCause::kTwoLights, "parting px", &Candidate::parting_px,
        static_cast<double>(most_parting_px(candidate.radius_px)), 1},
       {DropCause::kPoorFit, "residual", &Candidate::residual, settings.max_residual, 2},
       {DropCause::kOtherHue, "hue", &Candidate::hue, settings.max_hue, 2},
       {DropCause::kRedSurface, "peak", &Candidate::peak, surface, 0},
       {DropCause::kWeak, "amplitude", &Candidate::amplitude, settings.min_amplitude, 0}}};
}

/// So many decimals that a value beside its limit does not read as the limit itself.
std::string compared(std::string_view what, double measured, double limit, int decimals) {
  constexpr int kMostDecimals = 4;
  const auto text_of = [](double value, int digits) {
    const std::string text = fmt::format("{:.{}f}", value, digits);
    return text.find_first_not_of("-0.") == std::string::npos ? text.substr(text.find('0')) : text;  // no "-0.00"
  };
  const std::string shown_limit = text_of(limit, decimals);
  std::string shown = text_of(measured, decimals);
  for (int more = decimals + 1; shown == shown_limit && more <= kMostDecimals; ++more) {
    shown = text_of(measured, more);
  }
  return fmt::format("{} {} {} {}", what, shown, measured < limit ? '<' : '>', shown_limit);
}

std::string of_size(const Candidate& candidate, const LedDetectorSettings& settings, int width_px) {
  const double smallest_px = smallest_sigma_px(settings, width_px);
  const auto sigma_px = static_cast<double>(candidate.sigma_px);
  return compared("sigma", sigma_px, sigma_px < smallest_px ? smallest_px : largest_sigma_px(settings, width_px), 2);
}

std::string why_of_sphere(const Candidate& candidate, const SphereSettings& settings) {
  const auto radius_px = static_cast<double>(candidate.radius_px);
  const double radius_limit_px = radius_px < settings.min_radius_px ? settings.min_radius_px : settings.max_radius_px;
  switch (candidate.cause) {
    case DropCause::kKept:
      return fmt::format("radius {:.1f} px  outline {:.2f}", candidate.radius_px, candidate.outline);
    case DropCause::kOtherRadius:
      return compared("radius", radius_px, radius_limit_px, 1);
    case DropCause::kHiddenOutline:
      return compared("outline", static_cast<double>(candidate.outline), settings.min_outline, 2);
    case DropCause::kNotFilled:
      return compared("fill", static_cast<double>(candidate.fill), settings.min_fill, 2);
    case DropCause::kSprawling:
      return compared("beyond", static_cast<double>(candidate.spill), settings.max_spill, 2);
    case DropCause::kFitFailed:
      return "no circle in the outline";
    default:
      return {};
  }
}

std::string_view in_words(DropCause cause) {
  switch (cause) {
    case DropCause::kSeenBefore:
      return "reached from another place too";
    case DropCause::kNoFalloff:
      return "as bright all around";
    case DropCause::kTooLarge:
      return "no end in the largest window";
    case DropCause::kTooSmall:
      return "a single pixel";
    case DropCause::kNoSurround:
      return "surroundings not visible";
    case DropCause::kFitFailed:
      return "too little shows, or off centre";
    case DropCause::kCutByBorder:
      return "the picture ends inside";
    case DropCause::kBeyondBand:
      return "not all around it was decoded";
    case DropCause::kNoRoom:
      return "the list of points is full";
    case DropCause::kOtherRadius:
      return "too small or too large";
    case DropCause::kHiddenOutline:
      return "too little of the edge on a circle";
    case DropCause::kNotFilled:
      return "not red all over";
    case DropCause::kSprawling:
      return "red beyond the circle";
    default:
      return {};
  }
}

std::string why_of_led(const Candidate& candidate, const LedDetectorSettings& settings, int width_px) {
  const auto comparisons = comparisons_of(settings, candidate);
  const auto* const found = std::find_if(comparisons.begin(), comparisons.end(), [&](const Comparison& comparison) {
    return comparison.cause == candidate.cause;
  });
  if (found != comparisons.end()) {
    return compared(found->what, static_cast<double>(candidate.*found->measured), found->limit, found->decimals);
  }
  if (candidate.cause == DropCause::kWrongSize) return of_size(candidate, settings, width_px);
  if (candidate.cause == DropCause::kWrongProfile) {
    return fmt::format("sigma {:.2f} in radius {:.1f} px", candidate.sigma_px, candidate.radius_px);
  }
  if (candidate.cause == DropCause::kKept) {
    return fmt::format("redness {:.2f}  sigma {:.2f} px", candidate.redness, candidate.sigma_px);
  }
  return std::string{in_words(candidate.cause)};
}

}  // namespace

std::string cause_in_words(DropCause cause) {
  std::string words{name(cause)};
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string why(const Candidate& candidate, const DetectorSettings& settings, int width_px) {
  if (const auto* const sphere = std::get_if<SphereSettings>(&settings)) {
    const std::string reason = why_of_sphere(candidate, *sphere);
    return reason.empty() ? std::string{in_words(candidate.cause)} : reason;
  }
  return why_of_led(candidate, std::get<LedDetectorSettings>(settings), width_px);
}

}  // namespace tripoint
