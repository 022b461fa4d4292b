// The loop of one camera's thread: frame, planes, points, event; and opening anew whatever happens to the camera.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "capture/band_choice.h"
#include "capture/frame_rate.h"
#include "capture/mjpeg_decoder.h"
#include "capture/repeat_check.h"
#include "line/observation.h"
#include "ports/camera.h"
#include "ports/clock.h"
#include "values/bounded_queue.h"
#include "values/latest.h"

namespace tripoint {

/// What is known about one camera, for registers, management and log. Counters start with the worker.
struct CameraStatus {
  bool delivering = false;     ///< between the first frame after opening and the loss
  CameraInfo info;             ///< of the camera opened last
  double rate_hz = 0.0;        ///< over the last whole second of arrivals
  std::uint64_t frames = 0;    ///< that became observations
  std::uint64_t dropped = 0;   ///< numbers missing in the driver's sequence, damaged frames included
  std::uint64_t corrupt = 0;   ///< arrived damaged
  std::uint64_t repeated = 0;  ///< identical to the bit to one not long before: see RepeatCheck
  std::uint64_t losses = 0;    ///< times the camera stopped delivering, or could not be opened at first
  std::string last_error;      ///< "" until something went wrong; names the side
};

struct CameraLimits {
  Duration frame = std::chrono::milliseconds(500);  ///< without a frame for so long, the camera is lost
  Duration first_frame = std::chrono::seconds(2);   ///< the same from opening to the first frame: sensors start slowly
  Duration first_retry = std::chrono::milliseconds(200);
  Duration last_retry = std::chrono::seconds(2);  ///< the pause doubles from the first to this
  int corrupt_in_a_row = 5;                       ///< so many, and the camera is lost; a sixth of a second at 30 Hz
  int repeated_in_a_row = 30;  ///< the same; the line gives no pose from the first repeat on, so there is no hurry to
                               ///< close a camera that may only see a dark scene
};

using OpenCamera = std::function<Result<std::unique_ptr<Camera>>()>;
/// Fills in points, health, forecast_used, and coverage when it did not look everywhere; side, frame and times are the
/// worker's. It is asked picture by picture of one camera, and of MJPEG may get bands only.
using DetectPoints = std::function<Observation(const Picture&, const Forecast&)>;
/// What of a finished observation is believed. With such a task every picture is seen whole.
using SiftPoints = std::function<Observation(const Observation&, const Picture&)>;
/// Waits for the duration or until stop is requested, whichever comes first.
using Pause = std::function<void(Duration, const std::stop_token&)>;

void pause_until_stop(Duration duration, const std::stop_token& stop);

struct CameraTasks {
  OpenCamera open;
  DetectPoints detect;
  SiftPoints sift = {};         ///< none: every point is believed
  bool whole_pictures = false;  ///< no bands of MJPEG; with a task to sift there are none anyway
  Pause pause = pause_until_stop;
};

/// What a worker shares with other threads; all of it outlives the worker.
struct CameraLinks {
  BoundedQueue<Event>& events;
  const Latest<Forecast>& forecast;
  Latest<CameraStatus>& status;
  const Clock& clock;
};

class CameraWorker {
 public:
  CameraWorker(Side side, CameraTasks tasks, CameraLinks links, CameraLimits limits);

  /// Runs until stop is requested, noticed within limits.frame (a slow open() aside), or a recording is over.
  ///
  /// Pushes an Observation for each good frame; CameraLost once when the camera cannot be opened or stops delivering
  /// (timeout, unplugged, driver fault, damaged or repeated frames in a row, end of a recording); CameraBack before
  /// the first observation after a loss. After a loss a picture from before it is no sign of life: what was shown last
  /// is remembered over closing and opening.
  void run(const std::stop_token& stop);

 private:
  /// Since the camera was opened.
  struct Connection {
    TimePoint opened{};
    bool delivered = false;
    int corrupt_in_a_row = 0;
    int repeated_in_a_row = 0;
  };

  Error serve(const std::stop_token& stop);
  std::optional<Error> take(const Observation& observation);
  std::optional<Error> take(const Error& error);
  [[nodiscard]] bool may_still_start(const Error& error) const;
  Result<Observation> observe(Camera& camera);
  Result<Picture> picture_from(const Frame& frame, const Forecast& forecast);
  bool repeats(const Frame& frame, const Picture& picture);
  void count_frame(const Frame& frame);
  void deliver(const Observation& observation);
  void report_loss(const Error& error);
  void note(const Error& error);

  const Side side_;
  const CameraTasks tasks_;
  const CameraLinks links_;
  const CameraLimits limits_;
  MjpegDecoder decoder_;
  RepeatCheck repeat_check_;
  Sightings sightings_;  // since the camera was opened
  FrameRate rate_;
  CameraStatus status_;
  Connection connection_;
  std::optional<std::uint32_t> last_sequence_;
  bool lost_ = false;
};

}  // namespace tripoint
