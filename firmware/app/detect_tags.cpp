#include "app/detect_tags.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "app/exit_code.h"
#include "capture/image_file.h"
#include "tags/tag_detector.h"
#include "tags/tag_points.h"

namespace tripoint {
namespace {

using nlohmann::ordered_json;

ordered_json corners_as_json(const SeenTag& tag) {
  ordered_json corners = ordered_json::array();
  for (const RawPixel& corner : tag.outline.corners_px) corners.push_back({corner.u_px, corner.v_px});
  return corners;
}

/// Why the corners are rough, null when they are measured.
ordered_json why_rough(const TagOutline& outline) {
  if (outline.cause == TagCause::kKept) return nullptr;
  return name(outline.cause);
}

ordered_json as_json(const SeenTag& tag) {
  const MeasuredPlace centre = centre_of(tag.outline);
  const Matrix2& c = centre.covariance_px2;
  return {{"id", tag.decoded.id},
          {"u_px", centre.at.u_px},
          {"v_px", centre.at.v_px},
          {"covariance_px2", {{c(0, 0), c(0, 1)}, {c(1, 0), c(1, 1)}}},
          {"peak", tag.outline.lightest},
          {"saturated", clips(tag.outline)},
          {"corners_px", corners_as_json(tag)},
          {"rough", why_rough(tag.outline)},
          {"corrected_bits", tag.decoded.corrected_bits},
          {"margin", tag.decoded.margin}};
}

ordered_json dropped_as_json(const SeenTag& tag) {
  return {{"id", tag.decoded.id},
          {"cause", name(tag.outline.cause)},
          {"corners_px", corners_as_json(tag)},
          {"margin", tag.decoded.margin}};
}

ordered_json line_for(const std::filesystem::path& image, TagDetector& detector) {
  const Result<LoadedImage> loaded = LoadedImage::load(image);
  if (!loaded) return {{"image", image.string()}, {"error", loaded.error().message}};
  const SeenTags seen = detector.detect(loaded->picture());
  ordered_json points = ordered_json::array();
  ordered_json dropped = ordered_json::array();
  for (const SeenTag& tag : seen.tags) {
    if (tag.outline.cause == TagCause::kUnsureBits) {
      dropped.push_back(dropped_as_json(tag));
    } else {
      points.push_back(as_json(tag));
    }
  }
  return {{"image", image.string()}, {"looked_at", true}, {"cut", seen.cut}, {"points", points}, {"dropped", dropped}};
}

}  // namespace

int detect_tags(const DetectOptions& options, const DetectorConfig& config) {
  if (!options.explain.empty()) {
    return report(
        {ErrorCode::kMismatch, "--explain is for LEDs and spheres: why a tag was dropped stands in \"dropped\""});
  }
  Result<TagDetector> detector = TagDetector::open({.family = options.family, .min_margin = config.min_margin});
  if (!detector) return report({detector.error().code, "--family: " + detector.error().message});
  int code = number(ExitCode::kWell);
  for (const std::filesystem::path& image : options.images) {
    const ordered_json line = line_for(image, *detector);
    if (line.contains("error")) code = number(ExitCode::kUsage);
    fmt::print("{}\n", line.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }
  return code;
}

}  // namespace tripoint
