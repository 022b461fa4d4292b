#include "line/line.h"

#include <algorithm>
#include <utility>

#include "line/align/align.h"
#include "line/gate/gate.h"
#include "line/match/match.h"
#include "line/pose/pose.h"

namespace tripoint {
namespace {

std::shared_ptr<const LineModel> uncalibrated() {
  LineModel model;
  model.calibrated = false;
  return std::make_shared<const LineModel>(model);
}

}  // namespace

Line::Line(std::shared_ptr<const LineModel> model) { swap_model(std::move(model)); }

std::optional<Measurement> Line::step(const Event& event) {
  tracks_.take(event);
  clocks_.take(event);
  const Aligned seen = patience_.judged(align(tracks_, clocks_), tracks_);
  if (!seen.due) return std::nullopt;
  const Pairs pairs = match(seen, *model_);
  const Fit fit = pose_of_target(seen, pairs, *model_);
  decalibration_.learn(seen, pairs, fit, *model_);
  const Measurement gated = gate(seen, pairs, fit, *model_);
  const bool told_by_geometry = model_->target.tags.empty();  // which LED is which; tags say it themselves
  const Measurement measurement = decalibration_.judged(told_by_geometry ? confirmation_.judged(gated) : gated);
  monitor_.learn(measurement, pairs);  // health, motion
  return monitor_.completed(measurement, *model_);
}

void Line::swap_model(std::shared_ptr<const LineModel> model) {
  model_ = model ? std::move(model) : uncalibrated();
  tracks_.start_over(model_->limits.camera_silence);
  patience_.limit_to(model_->limits.camera_silence);
  clocks_.trust_offset_to(model_->limits.offset_prior_s);
  confirmation_.forget();
  decalibration_.watch(*model_);
  monitor_.forget_motion();
}

Forecast Line::forecast() const {
  const Duration ahead = std::max(clocks_[Side::kLeft].period(), clocks_[Side::kRight].period());
  return monitor_.forecast(ahead, *model_);
}

}  // namespace tripoint
