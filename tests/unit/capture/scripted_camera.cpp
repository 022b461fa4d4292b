#include "scripted_camera.h"

#include <utility>

namespace tripoint::test {
namespace {

class ScriptedCamera final : public Camera {
 public:
  ScriptedCamera(Script script, std::stop_source stop, bool last, Duration exposure)
      : script_(std::move(script)), stop_(std::move(stop)) {
    last_ = last;
    info_.name = "scripted";
    info_.exposure = exposure;
  }

  Result<Frame> next_frame(Duration) override {
    if (at_ == script_.size()) return failure(ErrorCode::kDeviceFault, "script is over");
    const Step& step = script_[at_++];
    if (last_ && at_ == script_.size()) stop_.request_stop();
    if (const auto* error = std::get_if<Error>(&step)) return tl::make_unexpected(*error);
    return frame_of(std::get<ScriptedFrame>(step));
  }

  [[nodiscard]] const CameraInfo& info() const override { return info_; }

 private:
  Frame frame_of(const ScriptedFrame& step) {
    constexpr std::size_t kStride_bytes = std::size_t{kScriptedSize.width_px} * 2;
    buffer_ = step.mjpeg.empty() ? std::vector(kStride_bytes * kScriptedSize.height_px - step.missing_bytes, step.value)
                                 : step.mjpeg;
    const TimePoint exposed = TimePoint{} + step.sequence * kScriptedPeriod;
    return {.side = Side::kLeft,
            .format = step.mjpeg.empty() ? PixelFormat::kYuyv : PixelFormat::kMjpeg,
            .size = step.mjpeg.empty() ? kScriptedSize : step.mjpeg_size,
            .stride_bytes = step.mjpeg.empty() ? kStride_bytes : 0,
            .data = buffer_,
            .sequence = step.sequence,
            .exposed = exposed,
            .arrived = exposed + std::chrono::milliseconds(20),
            .line_time = Duration{30'000}};
  }

  Script script_;
  std::stop_source stop_;
  bool last_ = false;
  std::size_t at_ = 0;
  std::vector<std::uint8_t> buffer_;
  CameraInfo info_;
};

}  // namespace

WorkerBench::WorkerBench(std::vector<std::variant<Script, Error>> openings, CameraLimits limits)
    : openings_(std::make_move_iterator(openings.begin()), std::make_move_iterator(openings.end())), limits_(limits) {}

void WorkerBench::run() {
  CameraTasks tasks{.open = [this] { return open(); },
                    .detect = [this](const Picture& p, const Forecast& f) { return detect(p, f); },
                    .sift = sift,
                    .pause = [this](Duration pause, const std::stop_token&) { pauses_.push_back(pause); }};
  CameraWorker worker(Side::kLeft, std::move(tasks), {queue_, forecast, status_, clock_}, limits_);
  worker.run(stop_.get_token());
  while (const auto event = queue_.pop(Duration{0})) events_.push_back(*event);
}

std::vector<Observation> WorkerBench::observations() const {
  std::vector<Observation> found;
  for (const Event& event : events_) {
    if (const auto* observation = std::get_if<Observation>(&event)) found.push_back(*observation);
  }
  return found;
}

Result<std::unique_ptr<Camera>> WorkerBench::open() {
  if (openings_.empty()) {
    stop_.request_stop();
    return failure(ErrorCode::kDeviceMissing, "no more openings");
  }
  const std::variant<Script, Error> opening = std::move(openings_.front());
  openings_.pop_front();
  if (const auto* error = std::get_if<Error>(&opening)) return tl::make_unexpected(*error);
  return std::make_unique<ScriptedCamera>(std::get<Script>(opening), stop_, openings_.empty(), exposure);
}

Observation WorkerBench::detect(const Picture& picture, const Forecast& known) {
  forecasts_seen.push_back(known.number);
  luma_seen.push_back(picture.luma.at(0, 0));
  numbers_seen.push_back(picture.frame);
  Observation observation;
  observation.coverage = looked_at;
  observation.forecast_used = known.number;
  ImagePoint point;
  point.at = spot;
  observation.points.push_back(point);
  return observation;
}

}  // namespace tripoint::test
