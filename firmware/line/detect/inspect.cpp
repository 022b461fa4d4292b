#include "line/detect/inspect.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "line/detect/falloff.h"
#include "line/detect/ground.h"
#include "line/detect/shared_chroma.h"

namespace tripoint {
namespace {

/// Of the contrast: a spot beside another stands alone higher up.
constexpr std::array<double, 3> kLevels{0.5, 0.7, 0.85};
constexpr int kPeakReach_px = 2;        ///< rows around the start in which the peak is sought
constexpr double kAloneAspect = 1.82;   ///< longer than this, the next level is tried
constexpr double kSplitLevel = 0.6;     ///< above it only the top of the spot stood alone
constexpr double kRoundAspect = 1.2;    ///< up to it an ellipse is taken for one LED seen from the side
constexpr double kUsualMisfit = 0.05;   ///< of the amplitude: tone curve, halo and mosaic
constexpr double kDoubtOfMisfit = 3.0;  ///< px of error for each px of sigma and misfit: rendered hidden and near spots
constexpr double kWellSampled_px = 1.15;   ///< a sharper spot falls between the mosaic's red pixels
constexpr double kDoubtOfSharpness = 0.6;  ///< px of error for each px of sigma below: rendered spots of 0.6 to 1.2 px
constexpr double kPixelGrain_px2 = 0.45;   ///< long^2 - short^2 of a block of 3 by 2 pixels
constexpr double kDoubtfulAspect = 1.4;    ///< from it on, for merged or partly hidden
/// From the middle of the red to the middle of the luma of an LED alone, px; halved rows of chroma say it more roughly.
constexpr double kUsualParting_px = 0.2;
constexpr double kUsualPartingHalved_px = 0.5;
constexpr double kDoubtOfParting = 2.0;  ///< px of error for each px beyond: rendered LEDs beside highlights

/// Half-windows in which a spot may fit; halos and big spots need the larger ones.
std::array<int, 3> half_windows(int width_px) {
  if (width_px > 2000) return {20, 30, 40};
  if (width_px > 1000) return {8, 20, 40};
  if (width_px > 400) return {8, 15, 28};
  return {8, 15, 20};
}

/// S that a spot of this size needs.
int needed_peak(const LedDetectorSettings& settings, const Picture& picture, double sigma_px = kSharpestSigma_px) {
  constexpr int kNoRed = 512;  // S of darkness
  const int red = std::max(0, settings.min_peak - kNoRed);
  return settings.min_peak - static_cast<int>((1.0 - strength_left(picture, sigma_px)) * red);
}

/// Two merged spots, or one of which half is hidden, have their centre about sqrt(long^2 - short^2) beside a LED's.
double doubt_of_stretched_px(const Area& area) {
  const double share = std::clamp((area.aspect() - kRoundAspect) / (kDoubtfulAspect - kRoundAspect), 0.0, 1.0);
  const double more_px2 =
      area.long_axis_px * area.long_axis_px - area.short_axis_px * area.short_axis_px - kPixelGrain_px2;
  return share * std::sqrt(std::max(more_px2, 0.0));
}

/// Of a Gaussian fitted on ground that is taken for level: 4 sigma^2 / A times the slope.
double displacement_by_slope_px(const SpotFit& fit, double slope) {
  return 4.0 * fit.model.sigma_px * fit.model.sigma_px / std::max(fit.visible_amplitude, 1.0) * slope;
}

/// Light that is not red beside an LED draws the centre of the luma away from it, but not that of its red.
double doubt_of_parting_px(double parting_px, const Picture& picture) {
  const double usual_px = picture.chroma_rows_halved ? kUsualPartingHalved_px : kUsualParting_px;
  return kDoubtOfParting * std::max(0.0, parting_px - usual_px);
}

}  // namespace

Inspection Inspector::inspect(const Picture& picture, PixelPlace start) {
  seen_ = {};
  seen_.start_u_px = start.u_px;
  seen_.start_v_px = start.v_px;
  seen_.at = {static_cast<double>(start.u_px), static_cast<double>(start.v_px)};
  seen_.needed_peak = static_cast<float>(needed_peak(settings_, picture));
  seen_.needed_contrast = static_cast<float>(settings_.min_contrast);
  point_.reset();
  half_loaded_ = 0;
  looked_ = {start.v_px, start.v_px + 1};
  look_at_rows(start.v_px, kPeakReach_px);
  seen_.cause = judge(picture);
  return {seen_, seen_.cause == DropCause::kKept ? point_ : std::nullopt, looked_};
}

void Inspector::look_at_rows(int middle_px, int reach_px) {
  looked_.top_px = std::min(looked_.top_px, middle_px - reach_px);
  looked_.bottom_px = std::max(looked_.bottom_px, middle_px + reach_px + 1);
}

/// Loads a usual spot's surroundings along with it.
SpotWindow::Part Inspector::part_around_start(const Picture& picture, int half) {
  constexpr int kUsualHalf = 15;
  const int shown = std::max(half, kUsualHalf);
  if (shown != half_loaded_) window_.load(picture, seen_.start_u_px, seen_.start_v_px, shown);
  half_loaded_ = shown;
  look_at_rows(seen_.start_v_px, half);
  return window_.around(seen_.start_u_px, seen_.start_v_px, half);
}

DropCause Inspector::judge(const Picture& picture) {
  using Gate = DropCause (Inspector::*)(const Picture&);
  constexpr std::array<Gate, 4> kGates{&Inspector::stand_out, &Inspector::isolate, &Inspector::compare_with_surround,
                                       &Inspector::fit};
  for (const Gate gate : kGates) {
    const DropCause cause = (this->*gate)(picture);
    if (cause != DropCause::kKept) return cause;
  }
  return DropCause::kKept;
}

DropCause Inspector::stand_out(const Picture& picture) {
  const PixelPlace start{seen_.start_u_px, seen_.start_v_px};
  const int peak = brightest_near(picture, start);
  seen_.peak = static_cast<float>(peak);
  if (seen_.peak < seen_.needed_peak) return DropCause::kDim;
  const std::optional<int> falloff = falloff_px(picture, start, peak - settings_.falloff);
  look_at_rows(start.v_px, falloff.value_or(0));
  return falloff ? DropCause::kKept : DropCause::kNoFalloff;
}

void Inspector::find_peak() {
  constexpr int kAsRed = 40;  // V: a brighter neighbour that is much less red is another thing
  const int column = seen_.start_u_px - window_.left_px();
  const int row = seen_.start_v_px - window_.top_px();
  const int red = window_.red(SpotWindow::index(column, row));
  int strongest = SpotWindow::kOutside;
  for (int y = row - 2; y <= row + 2; ++y) {
    for (int x = column - 2; x <= column + 2; ++x) {
      const std::size_t i = SpotWindow::index(x, y);
      if (window_.strength(i) <= strongest || window_.red(i) < red - kAsRed) continue;
      strongest = window_.strength(i);
      peak_ = {window_.left_px() + x, window_.top_px() + y};
    }
  }
  seen_.peak = static_cast<float>(strongest);
  seen_.red_step = static_cast<float>(red);
}

bool Inspector::spread_alone(const SpotWindow::Part& part, int background) {
  const std::size_t seed = SpotWindow::index(peak_.u_px - window_.left_px(), peak_.v_px - window_.top_px());
  for (const double level : kLevels) {
    seen_.level = static_cast<float>(level);
    threshold_ = background + static_cast<int>(level * static_cast<double>(seen_.contrast));
    area_ = flood_.spread(window_, part, seed, threshold_);
    if (!area_.leaves_part && area_.aspect() <= kAloneAspect) return true;
  }
  return !area_.leaves_part;
}

DropCause Inspector::isolate(const Picture& picture) {
  bool alone = false;
  const auto halves = half_windows(picture.size.width_px);
  for (const int half : halves) {
    const SpotWindow::Part part = part_around_start(picture, half);
    if (half == halves.front()) find_peak();
    const int background = background_of(window_, part);
    if (background == SpotWindow::kOutside) return DropCause::kNoSurround;
    seen_.contrast = seen_.peak - static_cast<float>(background);
    if (seen_.contrast < seen_.needed_contrast) return DropCause::kNoContrast;
    alone = spread_alone(part, background);
    if (alone) break;
  }
  if (!alone) return DropCause::kTooLarge;
  seen_.at = {window_.left_px() + area_.column, window_.top_px() + area_.row};
  seen_.radius_px = static_cast<float>(area_.radius_px());
  seen_.aspect = static_cast<float>(area_.aspect());
  if (area_.pixels < 2) return DropCause::kTooSmall;
  if (area_.cut_by_border) return DropCause::kCutByBorder;
  return area_.aspect() > settings_.max_aspect ? DropCause::kElongated : DropCause::kKept;
}

/// Makes the window large enough for the ring around the area.
void Inspector::show_surround(const Picture& picture) {
  const double reach_px = surround_reach_px(area_);
  const bool shown = area_.column >= reach_px && area_.column + reach_px <= window_.columns() - 1 &&
                     area_.row >= reach_px && area_.row + reach_px <= window_.rows() - 1;
  const auto center_u = static_cast<int>(std::lround(seen_.at.u_px));
  const auto center_v = static_cast<int>(std::lround(seen_.at.v_px));
  const int half = std::min(static_cast<int>(std::ceil(reach_px)) + 1, SpotWindow::kMaxHalf);
  look_at_rows(center_v, half);
  if (shown) return;
  window_.load(picture, center_u, center_v, half);
  area_ = flood_.spread(window_, window_.around(center_u, center_v, half),
                        SpotWindow::index(peak_.u_px - window_.left_px(), peak_.v_px - window_.top_px()), threshold_);
}

DropCause Inspector::compare_with_surround(const Picture& picture) {
  show_surround(picture);
  const int peak = static_cast<int>(seen_.peak);
  around_ = surround_of(window_, area_, peak);
  if (area_.leaves_part || around_.pixels == 0) return DropCause::kNoSurround;
  seen_.contrast = static_cast<float>(peak - around_.strength);
  seen_.needed_contrast =
      std::max(seen_.needed_contrast, static_cast<float>(settings_.min_contrast_of_noise * around_.strength_noise));
  if (seen_.contrast < seen_.needed_contrast) return DropCause::kNoContrast;
  seen_.crowding = static_cast<float>(around_.crowding);
  seen_.red_step -= static_cast<float>(around_.red);
  seen_.surround_red = static_cast<float>(around_.red);
  if (around_.crowding > settings_.max_crowding) return DropCause::kCrowded;
  if (seen_.red_step < static_cast<float>(settings_.min_red_step)) return DropCause::kNotRedder;
  seen_.redness = static_cast<float>(redness_of_flank(window_, area_, around_, peak));
  if (seen_.redness < static_cast<float>(settings_.min_redness)) return DropCause::kNotRed;
  const AreaLight light = light_of_area(window_, flood_, around_);
  seen_.emission = static_cast<float>(light.emission);
  if (seen_.emission < static_cast<float>(settings_.min_emission)) return DropCause::kNotEmitting;
  if (settings_.min_emission < 0.0) return DropCause::kKept;  // what takes luma away has no middle of its light
  seen_.parting_px = static_cast<float>(light.parting_px);
  return seen_.parting_px > most_parting_px(seen_.radius_px) ? DropCause::kTwoLights : DropCause::kKept;
}

DropCause Inspector::fit(const Picture& picture) {
  look_at_rows(static_cast<int>(std::lround(seen_.at.v_px)), ground_reach_px(area_.radius_px()));
  const GroundPlane ground = ground_plane(picture, seen_.at, area_.radius_px(),
                                          {around_.ground(Channel::kLuma), around_.noise(Channel::kLuma)});
  const auto measured = measurer_.measure({.window = window_,
                                           .flood = flood_,
                                           .area = area_,
                                           .around = around_,
                                           .level = static_cast<double>(seen_.level),
                                           .ground = ground});
  if (!measured) return DropCause::kFitFailed;
  note(*measured);
  if (picture.chroma_rows_halved) {  // a wider spot loses less red than the sharpest, which was let in
    seen_.needed_peak = static_cast<float>(needed_peak(settings_, picture, measured->fit.model.sigma_px));
    if (seen_.peak < seen_.needed_peak) return DropCause::kDim;
  }
  const DropCause cause = check(*measured, picture);
  if (cause == DropCause::kKept) make_point(*measured, picture);
  return cause;
}

void Inspector::note(const SpotMeasurement& measured) {
  const SpotFit& fit = measured.fit;
  const double amplitude = std::max(fit.visible_amplitude, 1.0);
  const double unexplained = std::max(0.0, fit.noise * fit.noise - measured.grain * measured.grain);
  seen_.at = {window_.left_px() + fit.model.column, window_.top_px() + fit.model.row};
  seen_.sigma_px = static_cast<float>(fit.model.sigma_px);
  seen_.amplitude = static_cast<float>(fit.visible_amplitude);
  seen_.residual = static_cast<float>(fit.noise / amplitude);
  seen_.misfit = static_cast<float>(std::sqrt(unexplained) / amplitude);
  seen_.hidden_pixels = measured.hidden_pixels;
}

DropCause Inspector::check(const SpotMeasurement& measured, const Picture& picture) const {
  if (measured.channel == Channel::kStrength && measured.fit.visible_amplitude < settings_.min_amplitude) {
    return DropCause::kWeak;
  }
  if (static_cast<double>(seen_.residual) > settings_.max_residual) return DropCause::kPoorFit;
  const double sigma_px = measured.fit.model.sigma_px;
  const int width_px = picture.size.width_px;
  if (sigma_px < smallest_sigma_px(settings_, width_px) || sigma_px > largest_sigma_px(settings_, width_px)) {
    return DropCause::kWrongSize;
  }
  const double share = measured.share_of_radius;
  return share < 0.3 || share > 1.35 ? DropCause::kWrongProfile : DropCause::kKept;
}

void Inspector::make_point(const SpotMeasurement& measured, const Picture& picture) {
  const SpotFit& fit = measured.fit;
  const bool by_strength = measured.channel == Channel::kStrength;
  double doubt_px2 = settings_.floor_px * settings_.floor_px;
  if (static_cast<double>(seen_.level) > kSplitLevel || by_strength) {
    doubt_px2 += settings_.split_floor_px * settings_.split_floor_px;
  }
  const double stretched_px = doubt_of_stretched_px(area_);
  const double misfit_px =
      kDoubtOfMisfit * fit.model.sigma_px * std::max(0.0, static_cast<double>(seen_.misfit) - kUsualMisfit);
  const double sharp_px = kDoubtOfSharpness * std::max(0.0, kWellSampled_px - fit.model.sigma_px);
  const double slope_px = displacement_by_slope_px(fit, measured.slope_left_in);
  const double parting_px = doubt_of_parting_px(static_cast<double>(seen_.parting_px), picture);
  doubt_px2 += stretched_px * stretched_px + misfit_px * misfit_px + sharp_px * sharp_px + slope_px * slope_px +
               parting_px * parting_px;
  point_ = ImagePoint{.at = seen_.at,
                      .covariance_px2 = fit.covariance_px2 + doubt_px2 * Matrix2::Identity(),
                      .label = std::nullopt,
                      .amplitude = fit.visible_amplitude,
                      .sigma_px = fit.model.sigma_px,
                      .peak = static_cast<double>(measured.peak_luma),
                      .saturated = measured.peak_luma >= settings_.luma_clip,
                      .weak = by_strength,
                      .reach_px = static_cast<int>(
                          std::ceil(std::max(seen_.at.v_px - looked_.top_px, looked_.bottom_px - 1 - seen_.at.v_px)))};
}

}  // namespace tripoint
