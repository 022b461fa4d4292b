#include "capture/camera_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace tripoint {
namespace {

// A driver that starts again counts from 0: a step back, which wraps to a huge step forward, is not a loss of frames.
constexpr std::uint32_t kLargestGap = 10'000;

std::uint32_t frames_missing(std::optional<std::uint32_t> last, std::uint32_t now) {
  if (!last) return 0;
  const std::uint32_t step = now - *last;
  return step >= 1 && step <= kLargestGap ? step - 1 : 0;
}

bool whole(const Frame& frame) {
  const std::size_t bytes_of_pixel = frame.format == PixelFormat::kYuyv ? 2 : 1;
  const auto width = static_cast<std::size_t>(std::max(frame.size.width_px, 0));
  const auto height = static_cast<std::size_t>(std::max(frame.size.height_px, 0));
  return frame.stride_bytes >= width * bytes_of_pixel && frame.data.size() >= frame.stride_bytes * height;
}

/// Messages of a camera begin with its name and so with its side; others get it here.
std::string about_side(Side side, std::string_view message) {
  const std::string camera = fmt::format("camera {}", name(side));
  if (message.starts_with(camera)) return std::string(message);
  if (message.starts_with(name(side))) return fmt::format("camera {}", message);
  return fmt::format("{}: {}", camera, message);
}

/// A picture is exposed before it arrives, but for the jitter of the stamp, and no driver keeps one for a second.
bool plausible(const Frame& frame) {
  constexpr Duration kStampJitter = std::chrono::milliseconds(20);
  constexpr Duration kLongestWay = std::chrono::seconds(1);
  const Duration way = frame.arrived - frame.exposed;
  return way >= -kStampJitter && way <= kLongestWay;
}

}  // namespace

void pause_until_stop(Duration duration, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, duration, [] { return false; });
}

CameraWorker::CameraWorker(Side side, CameraTasks tasks, CameraLinks links, CameraLimits limits)
    : side_(side), tasks_(std::move(tasks)), links_(links), limits_(limits) {}

void CameraWorker::run(const std::stop_token& stop) {
  Duration pause = limits_.first_retry;
  while (!stop.stop_requested()) {
    const std::uint64_t frames_before = status_.frames;
    const Error ending = serve(stop);
    if (stop.stop_requested()) return;
    report_loss(ending);
    if (ending.code == ErrorCode::kEndOfStream) return;
    if (status_.frames != frames_before) pause = limits_.first_retry;
    tasks_.pause(pause, stop);
    pause = std::min(2 * pause, limits_.last_retry);
  }
}

/// One connection, from opening to the error that ends it.
Error CameraWorker::serve(const std::stop_token& stop) {
  const Result<std::unique_ptr<Camera>> camera = tasks_.open();
  if (!camera) return camera.error();
  status_.info = (*camera)->info();
  last_sequence_.reset();
  rate_.restart();
  sightings_ = {};
  connection_ = {.opened = links_.clock.now()};
  while (!stop.stop_requested()) {
    const Result<Observation> observation = observe(**camera);
    const std::optional<Error> ending = observation ? take(*observation) : take(observation.error());
    if (ending) return *ending;
  }
  return {ErrorCode::kTimeout, "asked to stop"};
}

/// Only a new picture ends a row: damaged and repeated ones may take turns.
std::optional<Error> CameraWorker::take(const Observation& observation) {
  if (!observation.health.identical) {
    connection_ = {.opened = connection_.opened, .delivered = true};
    deliver(observation);
    return std::nullopt;
  }
  ++status_.repeated;
  if (lost_) {
    links_.status.put(status_);
  } else {
    deliver(observation);
  }
  if (++connection_.repeated_in_a_row < limits_.repeated_in_a_row) return std::nullopt;
  return Error{
      ErrorCode::kDeviceFault,
      fmt::format("frozen: the last {} pictures repeat earlier ones to the bit; it is opened anew, and if that "
                  "does not help, check that it is not covered, and plug it in again",
                  connection_.repeated_in_a_row)};
}

std::optional<Error> CameraWorker::take(const Error& error) {
  if (may_still_start(error)) return std::nullopt;
  if (error.code != ErrorCode::kCorruptFrame) return error;
  ++status_.corrupt;
  note(error);
  if (++connection_.corrupt_in_a_row < limits_.corrupt_in_a_row) return std::nullopt;
  return Error{ErrorCode::kCorruptFrame,
               fmt::format("{} damaged frames in a row, the last: {}{}", connection_.corrupt_in_a_row, error.message,
                           status_.info.port.empty() ? "" : "; check cable and bus")};
}

bool CameraWorker::may_still_start(const Error& error) const {
  return error.code == ErrorCode::kTimeout && !connection_.delivered &&
         links_.clock.now() - connection_.opened < limits_.first_frame;
}

Result<Observation> CameraWorker::observe(Camera& camera) {
  const Result<Frame> frame = camera.next_frame(limits_.frame);
  if (!frame) return tl::make_unexpected(frame.error());
  const bool all_rows = tasks_.sift || tasks_.whole_pictures;
  const Forecast forecast = all_rows ? Forecast{} : links_.forecast.get();
  Result<Picture> picture = picture_from(*frame, forecast);
  if (!picture) return tl::make_unexpected(picture.error());
  picture->frame = frame->sequence;
  if (!plausible(*frame)) return failure(ErrorCode::kCorruptFrame, "time stamp does not fit the time of arrival");
  count_frame(*frame);

  Observation observation = tasks_.detect(*picture, forecast);
  observation.side = side_;
  observation.frame = frame->sequence;
  observation.exposed = frame->exposed;
  observation.arrived = frame->arrived;
  observation.line_time = frame->line_time;
  if (camera.info().exposure > Duration{0}) observation.exposure = camera.info().exposure;
  if (!picture->bands.empty()) observation.coverage = Coverage::kRegions;
  observation.health.identical = repeats(*frame, *picture);
  sightings_ = with(sightings_, observation, forecast);
  return tasks_.sift ? tasks_.sift(observation, *picture) : observation;
}

bool CameraWorker::repeats(const Frame& frame, const Picture& picture) {
  return frame.format == PixelFormat::kMjpeg ? repeat_check_.repeats(decoder_.coded(), picture.size)
                                             : repeat_check_.repeats(picture);
}

/// What is in memory anyway is shown whole.
Result<Picture> CameraWorker::picture_from(const Frame& frame, const Forecast& forecast) {
  if (frame.format == PixelFormat::kMjpeg) {
    const RowBands bands = chosen_bands(sightings_, forecast, {side_, frame.sequence, frame.exposed, frame.size});
    return decoder_.decode(frame.data, frame.size, bands);
  }
  if (!whole(frame)) return failure(ErrorCode::kCorruptFrame, "frame shorter than its size asks for");
  return picture_of(frame);
}

void CameraWorker::count_frame(const Frame& frame) {
  status_.dropped += frames_missing(last_sequence_, frame.sequence);
  last_sequence_ = frame.sequence;
  rate_.take(frame.arrived);
  status_.rate_hz = rate_.rate_hz();
}

void CameraWorker::deliver(const Observation& observation) {
  ++status_.frames;
  status_.delivering = true;
  links_.status.put(status_);
  if (lost_) links_.events.push(CameraBack{side_, links_.clock.now()});
  lost_ = false;
  links_.events.push(observation);
}

void CameraWorker::report_loss(const Error& error) {
  status_.delivering = false;
  status_.rate_hz = 0.0;
  if (!lost_) ++status_.losses;
  note(error);
  if (!lost_) links_.events.push(CameraLost{side_, links_.clock.now()});
  lost_ = true;
}

void CameraWorker::note(const Error& error) {
  status_.last_error = about_side(side_, error.message);
  links_.status.put(status_);
}

}  // namespace tripoint
