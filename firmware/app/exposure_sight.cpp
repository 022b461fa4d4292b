#include "app/exposure_sight.h"

#include <algorithm>
#include <vector>

#include "app/detector_settings.h"
#include "line/detect/exposure_margin.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

constexpr int kPictures = 5;  ///< looked at

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What one camera shows over some pictures.
class OneSight {
 public:
  OneSight(const DetectorConfig& detector, std::size_t leds)
      : detector_(led_detector_settings(detector)), leds_(leds) {}

  void see(const Picture& picture) {
    const Detection detection = detector_.detect(picture, Forecast{});
    spots_ = detection.points.size();
    mean_luma_ = detection.health.mean_luma;
    if (spots_ != leds_) return;
    dimmest_.push_back(detection.health.dimmest_luma);
    brightest_.push_back(detection.health.peak_luma);
  }

  /// Absent when less than half of the pictures show exactly the target's LEDs.
  [[nodiscard]] std::optional<SeenPeaks> peaks() const {
    if (2 * dimmest_.size() <= static_cast<std::size_t>(kPictures)) return std::nullopt;
    return SeenPeaks{led_peak_from_luma(median(dimmest_)), led_peak_from_luma(median(brightest_))};
  }
  [[nodiscard]] std::size_t spots() const { return spots_; }
  [[nodiscard]] double mean_luma() const { return mean_luma_; }

 private:
  LedDetector detector_;
  std::size_t leds_;
  std::size_t spots_ = 0;
  double mean_luma_ = 0.0;
  std::vector<double> dimmest_;
  std::vector<double> brightest_;
};

}  // namespace

Result<Look> look_at_leds(const CameraPair& cameras, const DetectorConfig& detector, std::size_t leds) {
  Look look{.setting = cameras.setting(), .peaks = {}};
  for (const Side side : kBothSides) {
    OneSight sight(detector, leds);
    const Result<void> watched = cameras.watch(side, kPictures, [&](const Picture& picture) { sight.see(picture); });
    if (!watched) return tl::make_unexpected(watched.error());
    look.peaks[side] = sight.peaks();
    look.spots[side] = sight.spots();
    look.mean_luma[side] = sight.mean_luma();
  }
  return look;
}

}  // namespace tripoint
