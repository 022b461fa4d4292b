#include "app/exposure_sight.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "app/detector_settings.h"
#include "capture/mjpeg_decoder.h"
#include "line/detect/exposure_margin.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using std::chrono::microseconds;

constexpr int kSettling = 3;                    ///< frames until a new exposure shows for certain
constexpr int kFrames = 5;                      ///< looked at
constexpr int kMostBadFrames = 10;              ///< damaged ones, before the camera counts as broken
constexpr Duration kFrameLimit{2'000'000'000};  ///< sensors start slowly

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What one camera shows over some frames.
class OneSight {
 public:
  OneSight(const Config& config, std::size_t leds) : detector_(led_detector_settings(config.detector)), leds_(leds) {}

  Result<void> take(Camera& camera, int frames) {
    int bad = 0;
    while (frames > 0) {
      const Result<Frame> frame = camera.next_frame(kFrameLimit);
      const Result<Picture> picture = frame.and_then([&](const Frame& taken) { return picture_from(taken); });
      if (picture) {
        note(detector_.detect(*picture, Forecast{}));
        --frames;
      } else if (picture.error().code != ErrorCode::kCorruptFrame || ++bad > kMostBadFrames) {
        return tl::make_unexpected(picture.error());
      }
    }
    return {};
  }

  void forget() {
    dimmest_.clear();
    brightest_.clear();
  }

  /// Absent when less than half of the frames show exactly the target's LEDs.
  [[nodiscard]] std::optional<SeenPeaks> peaks() const {
    if (2 * dimmest_.size() <= static_cast<std::size_t>(kFrames)) return std::nullopt;
    return SeenPeaks{led_peak_from_luma(median(dimmest_)), led_peak_from_luma(median(brightest_))};
  }
  [[nodiscard]] std::size_t spots() const { return spots_; }
  [[nodiscard]] double mean_luma() const { return mean_luma_; }

 private:
  Result<Picture> picture_from(const Frame& frame) {
    if (frame.format == PixelFormat::kMjpeg) return decoder_.decode(frame.data, frame.size);
    return picture_of(frame);
  }

  void note(const Detection& detection) {
    spots_ = detection.points.size();
    mean_luma_ = detection.health.mean_luma;
    if (spots_ != leds_) return;
    dimmest_.push_back(detection.health.dimmest_luma);
    brightest_.push_back(detection.health.peak_luma);
  }

  LedDetector detector_;
  MjpegDecoder decoder_;
  std::size_t leds_;
  std::size_t spots_ = 0;
  double mean_luma_ = 0.0;
  std::vector<double> dimmest_;
  std::vector<double> brightest_;
};

microseconds exposure_of(const Camera& camera) {
  return std::chrono::duration_cast<microseconds>(camera.info().exposure);
}

}  // namespace

Result<ExposureSight::Opened> ExposureSight::open(microseconds exposure) {
  Config config = config_;
  config.cameras.exposure = exposure;
  Result<PerSide<OpenCamera>> supply = supply_(config);
  if (!supply) return tl::make_unexpected(supply.error());
  Opened opened{.supply = std::move(*supply), .cameras = {}};
  for (const Side side : kBothSides) {
    Result<std::unique_ptr<Camera>> camera = opened.supply[side]();
    if (!camera) return tl::make_unexpected(camera.error());
    opened.cameras[side] = std::move(*camera);
  }
  return opened;
}

Result<Look> ExposureSight::look(microseconds exposure) {
  const Result<Opened> opened = open(exposure);
  if (!opened) return tl::make_unexpected(opened.error());
  const PerSide<std::unique_ptr<Camera>>& cameras = opened->cameras;
  Look look{.exposure = exposure_of(*cameras.left), .peaks = {}};
  if (exposure_of(*cameras.right) != look.exposure) {
    return failure(ErrorCode::kMismatch,
                   fmt::format("the cameras read back different exposures for {} us: left {}, right {} us; use two "
                               "cameras of one kind",
                               exposure.count(), look.exposure.count(), exposure_of(*cameras.right).count()));
  }
  for (const Side side : kBothSides) {
    OneSight sight(config_, leds_);
    Result<void> taken = sight.take(*cameras[side], kSettling);
    sight.forget();
    if (taken) taken = sight.take(*cameras[side], kFrames);
    if (!taken) return tl::make_unexpected(taken.error());
    look.peaks[side] = sight.peaks();
    look.spots[side] = sight.spots();
    look.mean_luma[side] = sight.mean_luma();
  }
  return look;
}

Result<ExposureRange> ExposureSight::offered() {
  const Result<Opened> opened = open(config_.cameras.exposure);
  if (!opened) return tl::make_unexpected(opened.error());
  const auto period = static_cast<std::int64_t>(1e6 / config_.cameras.rate_hz);
  ExposureRange range{microseconds{1}, microseconds{period}};
  for (const Side side : kBothSides) {
    const CameraInfo& info = opened->cameras[side]->info();
    range.shortest = std::max(range.shortest, std::chrono::duration_cast<microseconds>(info.shortest_exposure));
    if (info.longest_exposure == Duration{0}) continue;
    range.longest = std::min(range.longest, std::chrono::duration_cast<microseconds>(info.longest_exposure));
  }
  return range;
}

}  // namespace tripoint
