#include "app/detection.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "app/detector_settings.h"
#include "line/detect/led_detector.h"
#include "tags/tag_points.h"
#include "tags/tag_tracker.h"

namespace tripoint {
namespace {

DetectPoints led_detection(const DetectorConfig& config) {
  const auto detector =
      std::make_shared<LedDetector>(led_detector_settings(config));  // shared: std::function must be copyable
  return [detector](const Picture& picture, const Forecast& forecast) {
    const Detection found = detector->detect(picture, forecast);
    Observation observation;
    observation.points = found.points;
    observation.health = found.health;
    observation.forecast_used = forecast.number;
    return observation;
  };
}

Result<DetectPoints> tag_detection(const DetectorConfig& config, const MeasuredTarget& target) {
  std::vector<int> ids;
  for (const TargetTag& tag : target.target.tags) ids.push_back(tag.id);
  Result<TagTracker> opened =
      TagTracker::open({.family = target.tag_family, .min_margin = config.min_margin, .ids = ids});
  if (!opened) return tl::make_unexpected(opened.error());
  for (const TargetTag& tag : target.target.tags) {
    if (tag.id >= opened->ids()) {
      return failure(ErrorCode::kOutOfRange, fmt::format("{} has no tag {}: permitted is 0 to {}", target.tag_family,
                                                         tag.id, opened->ids() - 1));
    }
  }
  const auto tracker = std::make_shared<TagTracker>(std::move(*opened));  // shared: as above
  return [tracker, ids](const Picture& picture, const Forecast& forecast) {
    const SeenTags& seen = tracker->see(picture);
    const TagPoints found = points_of(seen, ids);
    Observation observation;
    observation.coverage = seen.coverage;
    observation.points = found.points;
    observation.health = found.health;
    observation.forecast_used = forecast.number;
    return observation;
  };
}

}  // namespace

Result<DetectPoints> detection_of(const DetectorConfig& config, const MeasuredTarget& target) {
  if (config.kind == ConfiguredDetector::kAprilTag) return tag_detection(config, target);
  return led_detection(config);
}

bool needs_whole_pictures(const DetectorConfig& config) { return config.kind == ConfiguredDetector::kAprilTag; }

}  // namespace tripoint
