#include "line/detect/led_detector.h"

#include <algorithm>
#include <cmath>

#include "line/detect/start.h"

namespace tripoint {
namespace {

/// Whether the close look got as far as knowing the spot's extent and finding it round and red.
bool was_measured(const Candidate& candidate) {
  return candidate.cause == DropCause::kKept || candidate.cause >= DropCause::kFitFailed;
}

}  // namespace

LedDetector::LedDetector(const LedDetectorSettings& settings) : settings_(settings), inspector_(settings) {}

Detection LedDetector::detect(const Picture& picture, const Forecast& /*forecast*/) {
  log_.clear();
  detection_ = {};
  bands_ = picture.bands;
  height_px_ = picture.size.height_px;
  if (bands_.empty()) light_ = scene_light_of(picture);
  detection_.health.mean_luma = light_.mean_luma;
  map_.read(picture);
  const Selection selection = select_cells(map_, settings_);
  detection_.health.candidates_cut = selection.cut;
  for (const Cell& cell : selection.cells) look(picture, reddest_of_cell(picture, map_, cell));
  return detection_;
}

bool LedDetector::within_bands(const RowBand& rows) const {
  return bands_.empty() || std::any_of(bands_.begin(), bands_.end(), [&](const RowBand& band) {
           const bool from_the_first = band.top_px == 0 || rows.top_px >= band.top_px;
           const bool to_the_last = band.bottom_px == height_px_ || rows.bottom_px <= band.bottom_px;
           return from_the_first && to_the_last;
         });
}

void LedDetector::look(const Picture& picture, PixelPlace start) {
  std::optional<PixelPlace> next = start;
  while (next && within_bands({next->v_px, next->v_px + 1}) && !covered(*next)) {
    if (log_.full()) {
      detection_.health.candidates_cut = true;
      return;
    }
    keep(picture, inspector_.inspect(picture, *next));
    if (log_.back().cause != DropCause::kKept) return;
    next = reddest_beside(picture, map_, log_.back(), settings_.min_red);
  }
}

bool LedDetector::covered(PixelPlace start) const {
  return std::any_of(log_.begin(), log_.end(), [&](const Candidate& seen) {
    if (seen.start_u_px == start.u_px && seen.start_v_px == start.v_px) return true;
    const double reach = 1.5 * static_cast<double>(seen.radius_px) + 1.0;
    return was_measured(seen) && std::abs(seen.at.u_px - start.u_px) <= reach &&
           std::abs(seen.at.v_px - start.v_px) <= reach;
  });
}

DropCause LedDetector::judge_light(const Picture& picture, Candidate& candidate) const {
  candidate.hue = static_cast<float>(hue_of_flank(picture, candidate));
  candidate.red_surface = static_cast<float>(strength_of_red_surface(light_));
  if (static_cast<double>(candidate.hue) > settings_.max_hue) return DropCause::kOtherHue;
  if (settings_.min_emission < 0.0) return DropCause::kKept;  // red surfaces are what is looked for
  const float over_surface = candidate.peak - candidate.red_surface;
  return over_surface < static_cast<float>(settings_.min_over_surface) ? DropCause::kRedSurface : DropCause::kKept;
}

void LedDetector::keep(const Picture& picture, const Inspection& inspection) {
  Candidate candidate = inspection.candidate;
  if (inspection.point) {
    candidate.cause = within_bands(inspection.looked) ? judge_light(picture, candidate) : DropCause::kBeyondBand;
    // What would be a spot may be one: the picture has not shown all of it.
    if (candidate.cause == DropCause::kBeyondBand) detection_.health.candidates_cut = true;
    if (candidate.cause == DropCause::kKept) candidate.cause = make_room(candidate, *inspection.point);
  }
  log_.push_back(candidate);
}

DropCause LedDetector::make_room(const Candidate& candidate, const ImagePoint& point) {
  const bool known = std::any_of(log_.begin(), log_.end(), [&](const Candidate& seen) {
    const auto radius_px = static_cast<double>(std::max(seen.radius_px, candidate.radius_px));
    return seen.cause == DropCause::kKept &&
           std::hypot(seen.at.u_px - candidate.at.u_px, seen.at.v_px - candidate.at.v_px) < radius_px + 0.5;
  });
  if (known) return DropCause::kSeenBefore;
  ImageHealth& health = detection_.health;
  if (!detection_.points.try_push_back(point)) {
    health.candidates_cut = true;
    return DropCause::kNoRoom;
  }
  health.dimmest_luma = detection_.points.size() == 1 ? point.peak : std::min(health.dimmest_luma, point.peak);
  health.peak_luma = std::max(health.peak_luma, point.peak);
  health.focus = std::max(health.focus, 1.0 / point.sigma_px);
  return DropCause::kKept;
}

}  // namespace tripoint
