#include "line/detect/inspect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "line/detect/falloff.h"

namespace tripoint {
namespace {

/// Of the contrast: a spot beside another stands alone higher up.
constexpr std::array<double, 3> kLevels{0.5, 0.7, 0.85};
constexpr double kAloneAspect = 1.82;       ///< longer than this, the next level is tried
constexpr double kSplitLevel = 0.6;         ///< above it only the top of the spot stood alone
constexpr double kLargestLumaShare = 1.15;  ///< the spot may not be wider in Y than in S
constexpr double kSameCenter = 0.2;         ///< px, and of the radius: Y's centre against the area's
constexpr double kRoundAspect = 1.2;        ///< up to it an ellipse is taken for one LED seen from the side
constexpr double kUsualMisfit = 0.05;       ///< of the amplitude: tone curve, halo and mosaic
constexpr double kDoubtOfMisfit = 3.0;  ///< px of error for each px of sigma and misfit: rendered hidden and near spots
constexpr double kFade_px = 3.0;        ///< over more than the mosaic's cell of 2 px
constexpr double kPixelGrain_px2 = 0.45;  ///< long^2 - short^2 of a block of 3 by 2 pixels
constexpr double kDoubtfulAspect = 1.4;   ///< from it on, for merged or partly hidden

/// Half-windows in which a spot may fit; halos and big spots need the larger ones.
std::array<int, 3> half_windows(int width_px) {
  if (width_px > 1000) return {8, 20, 40};
  if (width_px > 400) return {8, 15, 28};
  return {8, 15, 20};
}

/// Two merged spots, or one of which half is hidden, have their centre about sqrt(long^2 - short^2) beside a LED's.
double doubt_of_stretched_px(const Area& area) {
  const double share = std::clamp((area.aspect() - kRoundAspect) / (kDoubtfulAspect - kRoundAspect), 0.0, 1.0);
  const double more_px2 =
      area.long_axis_px * area.long_axis_px - area.short_axis_px * area.short_axis_px - kPixelGrain_px2;
  return share * std::sqrt(std::max(more_px2, 0.0));
}

}  // namespace

Inspection Inspector::inspect(const Picture& picture, PixelPlace start) {
  seen_ = {};
  seen_.start_u_px = start.u_px;
  seen_.start_v_px = start.v_px;
  seen_.at = {static_cast<double>(start.u_px), static_cast<double>(start.v_px)};
  point_.reset();
  seen_.cause = judge(picture);
  return {seen_, seen_.cause == DropCause::kKept ? point_ : std::nullopt};
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
  if (peak < settings_.min_peak) return DropCause::kDim;
  return falls_below(picture, start, peak - settings_.falloff) ? DropCause::kKept : DropCause::kNoFalloff;
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

bool Inspector::spread_alone(int background) {
  const std::size_t seed = SpotWindow::index(peak_.u_px - window_.left_px(), peak_.v_px - window_.top_px());
  for (const double level : kLevels) {
    seen_.level = static_cast<float>(level);
    threshold_ = background + static_cast<int>(level * static_cast<double>(seen_.contrast));
    area_ = flood_.spread(window_, seed, threshold_);
    if (!area_.leaves_window && area_.aspect() <= kAloneAspect) return true;
  }
  return !area_.leaves_window;
}

DropCause Inspector::isolate(const Picture& picture) {
  bool alone = false;
  const auto halves = half_windows(picture.size.width_px);
  for (const int half : halves) {
    window_.load(picture, seen_.start_u_px, seen_.start_v_px, half);
    if (half == halves.front()) find_peak();
    const int background = background_of(window_);
    if (background == SpotWindow::kOutside) return DropCause::kNoSurround;
    seen_.contrast = seen_.peak - static_cast<float>(background);
    if (seen_.contrast < static_cast<float>(settings_.min_contrast)) return DropCause::kNoContrast;
    alone = spread_alone(background);
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
  if (shown) return;
  const auto center_u = static_cast<int>(std::lround(seen_.at.u_px));
  const auto center_v = static_cast<int>(std::lround(seen_.at.v_px));
  const int needed = static_cast<int>(std::ceil(reach_px)) + 1;
  window_.load(picture, center_u, center_v, std::min(needed, SpotWindow::kMaxHalf));
  area_ = flood_.spread(window_, SpotWindow::index(peak_.u_px - window_.left_px(), peak_.v_px - window_.top_px()),
                        threshold_);
}

DropCause Inspector::compare_with_surround(const Picture& picture) {
  show_surround(picture);
  const int peak = static_cast<int>(seen_.peak);
  around_ = surround_of(window_, area_, peak);
  if (area_.leaves_window || around_.pixels == 0) return DropCause::kNoSurround;
  seen_.contrast = static_cast<float>(peak - around_.strength);
  seen_.crowding = static_cast<float>(around_.crowding);
  seen_.red_step -= static_cast<float>(around_.red);
  seen_.surround_red = static_cast<float>(around_.red);
  if (around_.crowding > settings_.max_crowding) return DropCause::kCrowded;
  if (seen_.red_step < static_cast<float>(settings_.min_red_step)) return DropCause::kNotRedder;
  seen_.redness = static_cast<float>(redness_of_flank(window_, area_, around_, peak));
  if (seen_.redness < static_cast<float>(settings_.min_redness)) return DropCause::kNotRed;
  seen_.emission = static_cast<float>(emission_of_area(window_, flood_, around_));
  return seen_.emission < static_cast<float>(settings_.min_emission) ? DropCause::kNotEmitting : DropCause::kKept;
}

void Inspector::fill_fit_window(Channel channel) {
  const int reach = std::clamp(static_cast<int>(std::ceil(2.0 * area_.radius_px() + 1.5)), 4, SpotWindow::kMaxHalf);
  const auto center_column = static_cast<int>(std::lround(area_.column));
  const auto center_row = static_cast<int>(std::lround(area_.row));
  fit_left_ = std::max(0, center_column - reach);
  fit_top_ = std::max(0, center_row - reach);
  const int right = std::min(window_.columns() - 1, center_column + reach);
  const int bottom = std::min(window_.rows() - 1, center_row + reach);
  fit_window_.resize(right - fit_left_ + 1, bottom - fit_top_ + 1);
  const double reach2 = (reach + 0.5) * (reach + 0.5);
  seen_.hidden_pixels = own_hidden_pixels_ = 0;
  peak_luma_ = 0;
  for (int row = fit_top_; row <= bottom; ++row) {
    for (int column = fit_left_; column <= right; ++column) {
      const double d2 = (column - area_.column) * (column - area_.column) + (row - area_.row) * (row - area_.row);
      const std::size_t i = SpotWindow::index(column, row);
      if (d2 > reach2 || window_.outside(i)) continue;
      if (hidden(i)) {
        ++seen_.hidden_pixels;
        own_hidden_pixels_ += flood_.holds(i) ? 1 : 0;
      }
      peak_luma_ = std::max(peak_luma_, window_.luma(i));
      const float value = channel == Channel::kLuma ? static_cast<float>(window_.luma(i))
                                                    : 0.25F * static_cast<float>(window_.strength(i));
      fit_window_.set(column - fit_left_, row - fit_top_, value, 1.0F);
    }
  }
}

bool Inspector::hidden(std::size_t i) const {
  return window_.strength(i) >= settings_.hide_above || window_.luma(i) >= settings_.luma_clip;
}

/// Demosaicing carries a clipped value into the neighbours: they are hidden too.
void Inspector::hide_clipped(Core own_core) {
  for (int row = 0; row < fit_window_.rows(); ++row) {
    for (int column = 0; column < fit_window_.columns(); ++column) {
      const std::size_t i = SpotWindow::index(fit_left_ + column, fit_top_ + row);
      if (hidden(i) && (own_core == Core::kHidden || !flood_.holds(i))) fit_window_.hide_around(column, row);
    }
  }
}

/// The model never fits wholly (halo, mosaic). Hidden pixel by pixel, the core leaves a ragged edge, another one at
/// each place in the mosaic's cell, which turns the misfit into an error of the centre; a disc that fades does not.
/// How well the model fits stays what all pixels that show have said.
SpotFit Inspector::fitted_with_fading_core(const SpotFit& spot, Channel channel) {
  fill_fit_window(channel);
  hide_clipped(Core::kShown);
  const double clipped_px = std::sqrt(own_hidden_pixels_ / std::numbers::pi);
  if (own_hidden_pixels_ > 0) {
    fit_window_.fade_around(spot.model.column, spot.model.row, clipped_px, clipped_px + kFade_px);
  }
  auto better = fit_spot(fit_window_, spot.model);
  if (!better) return spot;
  better->noise = spot.noise;
  better->visible_amplitude = spot.visible_amplitude;
  return *better;
}

std::optional<SpotFit> Inspector::fit_channel(Channel channel) {
  fill_fit_window(channel);
  const double background = channel == Channel::kLuma ? around_.luma : 0.25 * around_.strength;
  const SpotModel start = threshold_subtracted_start(fit_window_, background);
  if (seen_.hidden_pixels > 0) hide_clipped(Core::kHidden);
  auto spot = fit_spot(fit_window_, start);
  if (spot && seen_.hidden_pixels > 0) spot = fitted_with_fading_core(*spot, channel);
  return spot && distance_from_area_px(*spot) < 0.5 * area_.radius_px() + 0.7 ? spot : std::nullopt;
}

/// Radius of the fitted Gaussian at the level of the area, over the area's radius.
double Inspector::share_of_radius(const SpotFit& spot) const {
  const double radius_px = spot.model.sigma_px * std::sqrt(-2.0 * std::log(static_cast<double>(seen_.level)));
  return radius_px / area_.radius_px();
}

double Inspector::distance_from_area_px(const SpotFit& spot) const {
  return std::hypot(fit_left_ + spot.model.column - area_.column, fit_top_ + spot.model.row - area_.row);
}

/// Y must be strong enough, and tell of the same spot as S: a white reflection beside the LED pulls Y only.
bool Inspector::luma_suffices(const SpotFit& spot) const {
  return spot.visible_amplitude >= settings_.weak_amplitude &&
         spot.noise <= settings_.max_residual * spot.visible_amplitude &&
         0.5 * spot.covariance_px2.trace() <= settings_.weak_sigma_px * settings_.weak_sigma_px &&
         share_of_radius(spot) <= kLargestLumaShare &&
         distance_from_area_px(spot) <= kSameCenter * (1.0 + area_.radius_px());
}

DropCause Inspector::fit(const Picture& picture) {
  Channel channel = Channel::kLuma;
  auto spot = fit_channel(channel);
  if (!spot || !luma_suffices(*spot)) {
    channel = Channel::kStrength;
    spot = fit_channel(channel);
  }
  if (!spot) return DropCause::kFitFailed;
  note_fit(*spot, channel);
  if (channel == Channel::kStrength && spot->visible_amplitude < settings_.min_amplitude) return DropCause::kWeak;
  const DropCause cause = check_fit(*spot, picture);
  if (cause == DropCause::kKept) make_point(*spot, channel);
  return cause;
}

void Inspector::note_fit(const SpotFit& spot, Channel channel) {
  const double amplitude = std::max(spot.visible_amplitude, 1.0);
  const RingNoise ring = ring_noise(window_, area_);
  const double noise = channel == Channel::kLuma ? ring.luma : 0.25 * ring.strength;
  seen_.at = {window_.left_px() + fit_left_ + spot.model.column, window_.top_px() + fit_top_ + spot.model.row};
  seen_.sigma_px = static_cast<float>(spot.model.sigma_px);
  seen_.amplitude = static_cast<float>(spot.visible_amplitude);
  seen_.residual = static_cast<float>(spot.noise / amplitude);
  seen_.misfit = static_cast<float>(std::sqrt(std::max(0.0, spot.noise * spot.noise - noise * noise)) / amplitude);
}

DropCause Inspector::check_fit(const SpotFit& spot, const Picture& picture) const {
  if (static_cast<double>(seen_.residual) > settings_.max_residual) return DropCause::kPoorFit;
  const double largest_px = std::max(settings_.max_sigma_px, settings_.max_sigma_of_width * picture.size.width_px);
  if (spot.model.sigma_px < settings_.min_sigma_px || spot.model.sigma_px > largest_px) return DropCause::kWrongSize;
  const double share = share_of_radius(spot);
  return share < 0.3 || share > 1.35 ? DropCause::kWrongProfile : DropCause::kKept;
}

void Inspector::make_point(const SpotFit& spot, Channel channel) {
  const bool by_strength = channel == Channel::kStrength;
  double doubt_px2 = settings_.floor_px * settings_.floor_px;
  if (static_cast<double>(seen_.level) > kSplitLevel || by_strength) {
    doubt_px2 += settings_.split_floor_px * settings_.split_floor_px;
  }
  const double stretched_px = doubt_of_stretched_px(area_);
  const double misfit_px =
      kDoubtOfMisfit * spot.model.sigma_px * std::max(0.0, static_cast<double>(seen_.misfit) - kUsualMisfit);
  doubt_px2 += stretched_px * stretched_px + misfit_px * misfit_px;
  point_ = ImagePoint{.at = seen_.at,
                      .covariance_px2 = spot.covariance_px2 + doubt_px2 * Matrix2::Identity(),
                      .label = std::nullopt,
                      .amplitude = spot.visible_amplitude,
                      .sigma_px = spot.model.sigma_px,
                      .peak = static_cast<double>(peak_luma_),
                      .saturated = seen_.peak >= static_cast<float>(settings_.clip),
                      .weak = by_strength};
}

}  // namespace tripoint
