// A camera that does what a script says, and a bench around a worker on which time stands still.
#pragma once

#include <deque>
#include <memory>
#include <stop_token>
#include <variant>
#include <vector>

#include "capture/camera_worker.h"

namespace tripoint::test {

/// A frame with this sequence number and this value in every byte; MJPEG data of a size instead when not empty.
struct ScriptedFrame {
  std::uint32_t sequence = 0;
  std::uint8_t value = 0;
  std::vector<std::uint8_t> mjpeg = {};
  std::size_t missing_bytes = 0;
  ImageSize mjpeg_size = {16, 8};
};
using Step = std::variant<ScriptedFrame, Error>;
using Script = std::vector<Step>;

inline constexpr ImageSize kScriptedSize{16, 8};
inline constexpr Duration kScriptedPeriod = std::chrono::milliseconds(40);

class StoppedClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return time_from_ns(7); }
  [[nodiscard]] Duration utc_offset() const override { return Duration{0}; }
  [[nodiscard]] bool synchronised() const override { return false; }
};

/// Runs a worker over one script for each time the camera is opened; stops it when the last script is at its end.
class WorkerBench {
 public:
  /// A step that is an error in `openings` makes open() fail; a script makes it succeed.
  explicit WorkerBench(std::vector<std::variant<Script, Error>> openings, CameraLimits limits = {});

  void run();

  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] const std::vector<Duration>& pauses() const { return pauses_; }
  [[nodiscard]] CameraStatus status() const { return status_.get(); }
  template <typename T>
  [[nodiscard]] std::size_t count() const {
    std::size_t n = 0;
    for (const Event& event : events_) n += std::holds_alternative<T>(event) ? 1U : 0U;
    return n;
  }
  [[nodiscard]] std::vector<Observation> observations() const;

  Duration exposure{0};  ///< that the camera reads back; 0 = not known
  SiftPoints sift;       ///< what is believed of what the detector finds; none: all
  Latest<Forecast> forecast;
  std::vector<std::uint64_t> forecasts_seen;
  std::vector<int> luma_seen;                  ///< of pixel (0, 0), by the detector
  std::vector<std::uint32_t> numbers_seen;     ///< of pictures
  RawPixel spot{3.5, 4.5};                     ///< that the detector finds in every picture
  Coverage looked_at = Coverage::kWholeFrame;  ///< of every picture that it is given

 private:
  Result<std::unique_ptr<Camera>> open();
  Observation detect(const Picture& picture, const Forecast& known);

  std::deque<std::variant<Script, Error>> openings_;
  CameraLimits limits_;
  std::stop_source stop_;
  BoundedQueue<Event> queue_{256};
  Latest<CameraStatus> status_;
  StoppedClock clock_;
  std::vector<Event> events_;
  std::vector<Duration> pauses_;
};

}  // namespace tripoint::test
