#include "line/detect/led_detector.h"

#include <algorithm>
#include <cmath>

#include "line/detect/start.h"

namespace tripoint {
namespace {

double mean_of_sparse_luma(const Picture& picture) {
  constexpr int kStep = 32;
  long sum = 0;
  long count = 0;
  for (int v = kStep / 2; v < picture.size.height_px; v += kStep) {
    for (int u = kStep / 2; u < picture.size.width_px; u += kStep) {
      sum += picture.luma.at(u, v);
      ++count;
    }
  }
  return count == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(count);
}

/// Whether the close look got as far as knowing the spot's extent and finding it round and red.
bool was_measured(const Candidate& candidate) {
  return candidate.cause == DropCause::kKept || candidate.cause >= DropCause::kFitFailed;
}

}  // namespace

LedDetector::LedDetector(const LedDetectorSettings& settings) : settings_(settings), inspector_(settings) {}

Detection LedDetector::detect(const Picture& picture, const Forecast& /*forecast*/) {
  log_.clear();
  detection_ = {};
  map_.read(picture);
  const Selection selection = select_cells(map_, settings_);
  detection_.health.candidates_cut = selection.cut;
  for (const Cell& cell : selection.cells) look(picture, reddest_of_cell(picture, map_, cell));
  detection_.health.mean_luma = mean_of_sparse_luma(picture);
  return detection_;
}

void LedDetector::look(const Picture& picture, PixelPlace start) {
  std::optional<PixelPlace> next = start;
  while (next && !covered(*next)) {
    if (log_.full()) {
      detection_.health.candidates_cut = true;
      return;
    }
    keep(inspector_.inspect(picture, *next));
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

void LedDetector::keep(const Inspection& inspection) {
  Candidate candidate = inspection.candidate;
  if (inspection.point) {
    const bool known = std::any_of(log_.begin(), log_.end(), [&](const Candidate& seen) {
      const auto radius_px = static_cast<double>(std::max(seen.radius_px, candidate.radius_px));
      return seen.cause == DropCause::kKept &&
             std::hypot(seen.at.u_px - candidate.at.u_px, seen.at.v_px - candidate.at.v_px) < radius_px + 0.5;
    });
    if (known) {
      candidate.cause = DropCause::kSeenBefore;
    } else if (!detection_.points.try_push_back(*inspection.point)) {
      candidate.cause = DropCause::kNoRoom;
      detection_.health.candidates_cut = true;
    } else {
      ImageHealth& health = detection_.health;
      health.peak_luma = std::max(health.peak_luma, inspection.point->peak);
      health.focus = std::max(health.focus, 1.0 / inspection.point->sigma_px);
    }
  }
  log_.push_back(candidate);
}

}  // namespace tripoint
