#include "app/measuring.h"

#include <optional>
#include <utility>
#include <variant>

namespace tripoint {
namespace {

constexpr Duration kTick = std::chrono::milliseconds(20);      ///< silence is noticed this fast
constexpr Duration kRefresh = std::chrono::milliseconds(200);  ///< cameras and clocks are told this often at least

std::optional<TimePoint> arrival(const Event& event) {
  const auto* observation = std::get_if<Observation>(&event);
  return observation == nullptr ? std::nullopt : std::optional(observation->arrived);
}

}  // namespace

Measuring::Measuring(MeasuringLinks links, std::shared_ptr<const LineModel> model, CalibrationFits calibration_fits,
                     UnitReport report)
    : links_(links),
      model_(std::move(model)),
      calibration_fits_(std::move(calibration_fits)),
      report_(std::move(report)),
      line_(model_) {}

void Measuring::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const std::optional<Event> event = links_.events.pop(kTick);
    step(event ? *event : Event{Tick{links_.clock.now()}});
  }
  report_.stop();
  publish({links_.cameras.left.get(), links_.cameras.right.get()}, links_.clock.now());
}

void Measuring::step(const Event& event) {
  const PerSide<CameraStatus> cameras{links_.cameras.left.get(), links_.cameras.right.get()};
  const bool swapped = check_cameras(cameras);  // before the step: no pose of a calibration that belongs to others
  const std::optional<Measurement> measurement = line_.step(event);
  const TimePoint now = links_.clock.now();
  if (!measurement && !swapped && now - published_ < kRefresh) return;

  if (measurement) report_.take(*measurement, arrival(event), links_.clock);
  publish(cameras, now);
  if (measurement) links_.forecast.put(line_.forecast());
  log_.take(cameras);
}

void Measuring::publish(const PerSide<CameraStatus>& cameras, TimePoint now) {
  links_.publication.publish(report_.state(cameras, links_.clock), now);
  published_ = now;
}

bool Measuring::check_cameras(const PerSide<CameraStatus>& cameras) {
  if (!model_) return false;
  const bool fits = calibration_fits_(cameras);
  if (fits == model_->calibration_fits) return false;
  LineModel changed = *model_;
  changed.calibration_fits = fits;
  model_ = std::make_shared<const LineModel>(std::move(changed));
  line_.swap_model(model_);
  report_.withdraw_pose(Fault::kCalibrationDoesNotFit);
  return true;
}

}  // namespace tripoint
