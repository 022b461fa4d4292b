#include "app/replay_command.h"

#include <fmt/core.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/datum_check.h"
#include "app/detection.h"
#include "app/exit_code.h"
#include "app/unit_setup.h"
#include "app/verdict_json.h"
#include "calibration/calibration.h"
#include "capture/mjpeg_decoder.h"
#include "capture/repeat_check.h"
#include "config/config.h"
#include "config/target_file.h"
#include "line/line.h"
#include "line/pose/output_frame.h"
#include "recording/recording_reader.h"

namespace tripoint {
namespace {

struct Replay {
  Config config;
  LineModel model;
  PerSide<DetectPoints> detect;
  OutputFrame frame = OutputFrame::kReference;
};

/// A detector for each camera: it may remember its last pictures.
Result<PerSide<DetectPoints>> detections_of(const DetectorConfig& config, const MeasuredTarget& target) {
  PerSide<DetectPoints> both;
  for (const Side side : kBothSides) {
    Result<DetectPoints> one = detection_of(config, target);
    if (!one) return tl::make_unexpected(one.error());
    both[side] = std::move(*one);
  }
  return both;
}

/// A calibration made at another picture size measures nonsense.
Result<void> check_size(const LineModel& model, ImageSize recorded) {
  for (const Side side : kBothSides) {
    const ImageSize& calibrated = model.calibration.cameras[side].size;
    if (calibrated == recorded) continue;
    return failure(
        ErrorCode::kMismatch,
        fmt::format("the {} camera is calibrated at {}x{}, the recording is {}x{}: use the calibration made "
                    "at that size",
                    name(side), calibrated.width_px, calibrated.height_px, recorded.width_px, recorded.height_px));
  }
  return {};
}

/// Lamps and LEDs look the same without it.
Result<void> check_unmodulated(const Config& config) {
  if (!config.modulation.enabled) return {};
  return tl::make_unexpected(
      named_by(config, "modulation.enabled",
               {ErrorCode::kMismatch, "a recording does not say which LEDs were lit when: to replay one set false"}));
}

/// Limits and volume of a configuration, or the defaults without a volume.
Result<Replay> prepared(const ReplayOptions& options) {
  Replay replay;
  if (!options.config.empty()) {
    Result<Config> config = load_config(options.config, {});
    const Result<void> usable = config.and_then([](const Config& loaded) {
      return check_detector(loaded).and_then([&] { return check_unmodulated(loaded); });
    });
    if (!usable) return tl::make_unexpected(usable.error());
    replay.config = std::move(*config);
  }
  const Result<Calibration> calibration = load_calibration(options.calibration);
  if (!calibration) return tl::make_unexpected(calibration.error());
  const Result<TargetFile> target =
      options.target.empty() ? Result<TargetFile>(single_led()) : load_target(options.target);
  if (!target) return tl::make_unexpected(target.error());
  if (options.config.empty() && target->kind == TargetKind::kAprilTag) {
    replay.config.detector.kind = ConfiguredDetector::kAprilTag;
  }
  const Result<MeasuredTarget> measured = measured_target(*target, replay.config);
  if (!measured)
    return failure(measured.error().code, options.target.empty()
                                              ? "--target: " + measured.error().message
                                              : options.target.string() + ": " + measured.error().message);
  Result<PerSide<DetectPoints>> detect = detections_of(replay.config.detector, *measured);
  if (!detect) return tl::make_unexpected(detect.error());
  replay.detect = std::move(*detect);
  Result<LineModel> model = line_model(*calibration, measured->target, replay.config);
  if (!model) return tl::make_unexpected(model.error());
  replay.model = std::move(*model);
  if (const Result<void> datum = check_datum(replay.config, &replay.model); !datum) {
    return tl::make_unexpected(datum.error());
  }
  if (options.config.empty()) replay.model.volume.reset();
  if (options.frame == "left_camera") replay.frame = OutputFrame::kLeftCamera;
  give_poses_in(replay.frame, replay.model);
  return replay;
}

/// Turns rows of a recording into the events that the camera threads would have sent.
class EventMaker {
 public:
  explicit EventMaker(PerSide<DetectPoints> detect) : detect_(std::move(detect)) {}

  /// @return kCorruptFrame, naming the file, for a picture that cannot be decoded
  Result<Event> event(const RecordedItem& item, const RecordingReader& reader) {
    if (const auto* lost = std::get_if<CameraLost>(&item)) return Event{*lost};
    if (const auto* back = std::get_if<CameraBack>(&item)) return Event{*back};
    const auto& frame = std::get<Frame>(item);
    return observed(frame).map([](const Observation& seen) { return Event{seen}; }).map_error([&](const Error& error) {
      const std::string file = reader.picture_file(frame.side, frame.sequence).string();
      return Error{error.code, fmt::format("{}: {}", file, error.message)};
    });
  }

 private:
  Result<Observation> observed(const Frame& frame) {
    const bool packed = frame.format == PixelFormat::kMjpeg;
    Result<Picture> picture = packed ? decoder_.decode(frame.data, frame.size) : Result<Picture>(picture_of(frame));
    if (!picture) return tl::make_unexpected(picture.error());
    picture->frame = frame.sequence;
    Observation seen = detect_[frame.side](*picture, Forecast{});
    seen.side = frame.side;
    seen.frame = frame.sequence;
    seen.exposed = frame.exposed;
    seen.arrived = frame.arrived;
    seen.line_time = frame.line_time;
    RepeatCheck& repeats = repeats_[frame.side];
    seen.health.identical = packed ? repeats.repeats(decoder_.coded(), frame.size) : repeats.repeats(*picture);
    return seen;
  }

  PerSide<DetectPoints> detect_;
  MjpegDecoder decoder_;
  PerSide<RepeatCheck> repeats_;
};

/// Frames of a recording, as far as they were of use. Like a camera's thread, a replay goes on after a damaged one.
class FrameTally {
 public:
  void used(const Event& event) { used_ += std::holds_alternative<Observation>(event) ? 1U : 0U; }
  /// Tells the first at once; the rest are counted.
  void unusable(const Error& error) {
    if (unusable_++ == 0) fmt::print(stderr, "tripointd: {}\n", error.message);
  }
  /// @return the exit code: that nothing at all was of use is an error
  [[nodiscard]] int told(const std::filesystem::path& folder) const {
    if (used_ == 0) {
      return report(
          {ErrorCode::kMalformed, fmt::format("{}: none of its {} frames could be used", folder.string(), unusable_)});
    }
    if (unusable_ > 1) {
      fmt::print(stderr, "tripointd: {}: {} of {} frames could not be used\n", folder.string(), unusable_,
                 used_ + unusable_);
    }
    return number(ExitCode::kWell);
  }

 private:
  std::size_t used_ = 0;
  std::size_t unusable_ = 0;
};

}  // namespace

int replay_command(const ReplayOptions& options) {
  Result<Replay> replay = prepared(options);
  if (!replay) return report(replay.error());
  Result<RecordingReader> reader = RecordingReader::open(options.folder);
  if (!reader) return report(reader.error());
  const Result<void> size = check_size(replay->model, reader->description().size);
  if (!size) return report(size.error());

  Line line(std::make_shared<const LineModel>(replay->model));
  EventMaker events(std::move(replay->detect));
  FrameTally tally;
  while (const std::optional<Result<RecordedItem>> item = reader->next()) {
    const Result<Event> event = item->and_then([&](const RecordedItem& row) { return events.event(row, *reader); });
    if (!event) {
      tally.unusable(event.error());
      continue;
    }
    tally.used(*event);
    if (const std::optional<Measurement> verdict = line.step(*event)) {
      fmt::print("{}\n", verdict_json(*verdict, replay->frame));
    }
  }
  return tally.told(options.folder);
}

}  // namespace tripoint
