// One side of a recording behind the same interface as a camera.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "ports/camera.h"
#include "ports/clock.h"
#include "recording/recording_reader.h"

namespace tripoint {

/// How a recording is played. Clock and waiting outlive the cameras.
struct Playback {
  const Clock& clock;
  WaitUntil wait_until;
  TimePoint start{};  ///< the clock's time at which the recording's first frame arrives; the same for both sides
};

class RecordedCamera final : public Camera {
 public:
  using Opener = std::function<Result<std::unique_ptr<Camera>>()>;

  /// How to open one side again and again: each opening goes on after the last frame of the one before.
  ///
  /// @return errors of RecordingReader::open
  static Result<Opener> opener(const std::filesystem::path& folder, Side side, const Playback& playback);

  /// As Camera says, at the recording's own pace. All times are moved so that the recording starts at playback.start.
  /// Frames that nobody fetched in time are left out; a gap in the recording is a kTimeout, a picture that cannot be
  /// read a kCorruptFrame, and kEndOfStream comes after the last one.
  Result<Frame> next_frame(Duration limit) override;
  [[nodiscard]] const CameraInfo& info() const override { return info_; }

 private:
  struct Position {
    std::size_t row = 0;  ///< into `rows_`
  };

  RecordedCamera(RecordingReader reader, Side side, Playback playback, std::shared_ptr<Position> position);

  [[nodiscard]] TimePoint due(std::size_t row) const { return rows_[row].arrived + shift_; }

  RecordingReader reader_;
  Playback playback_;
  std::shared_ptr<Position> position_;  ///< shared with the opener and so with the next opening
  std::vector<RecordedRow> rows_;       ///< frames of this side
  Duration shift_{0};
  CameraInfo info_;
};

}  // namespace tripoint
