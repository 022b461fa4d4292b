#include "line/detect/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "line/detect/vectors.h"

namespace tripoint {
namespace {

constexpr double kLargestLumaShare = 1.15;  ///< the spot may not be wider in Y than in S
constexpr double kSameCenter = 0.2;         ///< px, and of the radius: Y's centre against the area's
constexpr double kFade_px = 3.0;            ///< over more than the mosaic's cell of 2 px
constexpr double kReach = 1.6;              ///< of the radius at half contrast: 1.9 sigma
constexpr double kRoughly_px = 0.1;         ///< a first fit that another one follows need not settle further

double distance_px(const SpotModel& model, const Area& area) {
  return std::hypot(model.column - area.column, model.row - area.row);
}

double share_of_radius(const SpotModel& model, const IsolatedSpot& spot) {
  return model.sigma_px * std::sqrt(-2.0 * std::log(spot.level)) / spot.area.radius_px();
}

/// In S as in Y the same share of the ground's unevenness is grain, the rest is pattern.
double grain(const IsolatedSpot& spot, Channel channel) {
  const double uneven = spot.around.noise(Channel::kLuma);
  const double share = uneven > 0.0 ? std::min(1.0, spot.ground.grain / uneven) : 1.0;
  return share * spot.around.noise(channel);
}

/// Whether the slope is taken off before the fit.
bool levels(const GroundPlane& ground, Channel channel) { return channel == Channel::kLuma && !ground.rough; }

/// Luma of one row less its ground, which starts at `ground` and rises by `slope` a column; whole vectors.
void level(const std::uint8_t* lumas, float ground, float slope, std::span<float> values) {
  Floats4 rise = Floats4{0.0F, 1.0F, 2.0F, 3.0F} * slope + ground;
  for (std::size_t i = 0; i < values.size(); i += 4, rise += 4.0F * slope) {
    store(values.data() + i, floats_of(loaded<Bytes4>(lumas + i)) - rise);
  }
}

/// A quarter of the strength of one row; whole vectors.
void quarter(const std::int16_t* strengths, std::span<float> values) {
  for (std::size_t i = 0; i < values.size(); i += 4) {
    store(values.data() + i, 0.25F * floats_of(loaded<Shorts4>(strengths + i)));
  }
}

}  // namespace

std::optional<SpotMeasurement> SpotMeasurer::measure(const IsolatedSpot& spot) {
  frame(spot);
  note_clipped(spot);
  auto measured = measure_on(spot, Channel::kLuma);
  return measured && luma_suffices(spot, *measured) ? measured : measure_on(spot, Channel::kStrength);
}

void SpotMeasurer::frame(const IsolatedSpot& spot) {
  const auto center_column = static_cast<int>(std::lround(spot.area.column));
  const auto center_row = static_cast<int>(std::lround(spot.area.row));
  const SpotWindow::Part shown = spot.window.in_picture();
  const int reach =
      std::clamp(static_cast<int>(std::ceil(kReach * spot.area.radius_px() + 1.5)), 4, SpotWindow::kMaxHalf);
  box_.left = std::max(shown.left, center_column - reach);
  box_.top = std::max(shown.top, center_row - reach);
  box_.right = std::min(shown.right, center_column + reach);
  box_.bottom = std::min(shown.bottom, center_row + reach);
  runs_.clear();
  const Disc seen{.column = spot.area.column, .row = spot.area.row, .inner_px = -1.0, .outer_px = reach + 0.5};
  for_each_run(box_, seen, [&](const Run& run) { runs_.push_back(run); });
}

void SpotMeasurer::note_clipped(const IsolatedSpot& spot) {
  clipped_.clear();
  own_clipped_pixels_ = 0;
  peak_luma_ = 0;
  for (const Run& run : runs_) {
    const std::size_t end = SpotWindow::index(run.last, run.row) + 1;
    for (std::size_t i = SpotWindow::index(run.first, run.row); i < end; ++i) {
      const int luma = spot.window.luma(i);
      peak_luma_ = std::max(peak_luma_, luma);
      if (spot.window.strength(i) < settings_.hide_above && luma < settings_.luma_clip) continue;
      clipped_.push_back(static_cast<std::uint16_t>(i));
      own_clipped_pixels_ += spot.flood.holds(i) ? 1 : 0;
    }
  }
}

/// Luma on level ground: what the slope of the ground explains is taken off.
void SpotMeasurer::fill(const IsolatedSpot& spot, Channel channel) {
  fit_window_.resize(box_.right - box_.left + 1, box_.bottom - box_.top + 1);
  const Vec2 slope = levels(spot.ground, channel) ? spot.ground.slope : Vec2(0.0, 0.0);
  for (int row = 0; row < fit_window_.rows(); ++row) {
    const std::size_t first = SpotWindow::index(box_.left, box_.top + row);
    const std::span<float> values = fit_window_.whole_vectors(row);
    if (channel == Channel::kLuma) {
      const Vec2 beside_px(box_.left - spot.area.column, box_.top + row - spot.area.row);
      level(spot.window.lumas(first), static_cast<float>(slope.dot(beside_px)), static_cast<float>(slope.x()), values);
    } else {
      quarter(spot.window.strengths(first), values);
    }
    std::fill(values.begin() + fit_window_.columns(), values.end(), 0.0F);
  }
  show_disc();
}

void SpotMeasurer::show_disc() {
  for (const Run& run : runs_) {
    float* weights = fit_window_.weights(run.row - box_.top);
    std::fill(weights + (run.first - box_.left), weights + (run.last - box_.left) + 1, 1.0F);
  }
}

/// Demosaicing carries a clipped value into the neighbours: they are hidden too.
void SpotMeasurer::hide_clipped(const IsolatedSpot& spot, bool own_core) {
  for (const std::uint16_t i : clipped_) {
    if (!own_core && spot.flood.holds(i)) continue;
    fit_window_.hide_around(i % SpotWindow::kStride - box_.left, i / SpotWindow::kStride - box_.top);
  }
}

/// The model never fits wholly (halo, mosaic). Hidden pixel by pixel, the core leaves a ragged edge, another one at
/// each place in the mosaic's cell, which turns the misfit into an error of the centre; a disc that fades does not.
/// How well the model fits stays what all pixels that show have said.
SpotFit SpotMeasurer::fitted_with_fading_core(const IsolatedSpot& spot, const SpotFit& first) {
  show_disc();
  hide_clipped(spot, false);
  const double clipped_px = std::sqrt(own_clipped_pixels_ / std::numbers::pi);
  if (own_clipped_pixels_ > 0) {
    fit_window_.fade_around(first.model.column, first.model.row, clipped_px, clipped_px + kFade_px);
  }
  auto better = fit_spot(fit_window_, first.model);
  if (!better) return first;
  better->noise = first.noise;
  better->visible_amplitude = first.visible_amplitude;
  return *better;
}

std::optional<SpotMeasurement> SpotMeasurer::measure_on(const IsolatedSpot& spot, Channel channel) {
  fill(spot, channel);
  const SpotModel start = threshold_subtracted_start(fit_window_, spot.around.ground(channel));
  hide_clipped(spot, true);
  auto fit = clipped_.empty() ? fit_spot(fit_window_, start) : fit_spot(fit_window_, start, kRoughly_px);
  if (fit && !clipped_.empty()) fit = fitted_with_fading_core(spot, *fit);
  if (!fit) return std::nullopt;
  fit->model.column += box_.left;
  fit->model.row += box_.top;
  if (distance_px(fit->model, spot.area) >= 0.5 * spot.area.radius_px() + 0.7) return std::nullopt;
  return SpotMeasurement{.fit = *fit,
                         .channel = channel,
                         .grain = grain(spot, channel),
                         .slope_left_in = levels(spot.ground, channel) ? 0.0 : spot.ground.slope.norm(),
                         .share_of_radius = share_of_radius(fit->model, spot),
                         .hidden_pixels = static_cast<int>(clipped_.size()),
                         .peak_luma = peak_luma_};
}

/// Y must be strong enough, and tell of the same spot as S: a white reflection beside the LED pulls Y only.
bool SpotMeasurer::luma_suffices(const IsolatedSpot& spot, const SpotMeasurement& measured) const {
  const SpotFit& fit = measured.fit;
  return fit.visible_amplitude >= settings_.weak_amplitude &&
         fit.noise <= settings_.max_residual * fit.visible_amplitude &&
         0.5 * fit.covariance_px2.trace() <= settings_.weak_sigma_px * settings_.weak_sigma_px &&
         measured.share_of_radius <= kLargestLumaShare &&
         distance_px(fit.model, spot.area) <= kSameCenter * (1.0 + spot.area.radius_px());
}

}  // namespace tripoint
