#include "app/detect_tags.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/exit_code.h"
#include "app/explanation_folder.h"
#include "capture/image_file.h"
#include "explain/png_encoder.h"
#include "explain/tag_explanation.h"
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

/// The tags of one picture after the other.
class TagReader {
 public:
  TagReader(TagDetector detector, double min_margin, std::optional<ExplanationFolder> folder)
      : detector_(std::move(detector)), min_margin_(min_margin), folder_(std::move(folder)) {}

  ordered_json line_for(const std::filesystem::path& image) {
    const Result<LoadedImage> loaded = LoadedImage::load(image);
    if (!loaded) {
      code_ = number(ExitCode::kUsage);
      return {{"image", image.string()}, {"error", loaded.error().message}};
    }
    const SeenTags seen = detector_.detect(loaded->picture());
    ordered_json points = ordered_json::array();
    ordered_json dropped = ordered_json::array();
    for (const SeenTag& tag : seen.tags) {
      if (tag.outline.cause == TagCause::kUnsureBits) {
        dropped.push_back(dropped_as_json(tag));
      } else {
        points.push_back(as_json(tag));
      }
    }
    ordered_json line = {
        {"image", image.string()}, {"looked_at", true}, {"cut", seen.cut}, {"points", points}, {"dropped", dropped}};
    if (folder_) explain(explanation_of(loaded->picture(), seen, min_margin_, image.filename().string()), image, line);
    return line;
  }

  /// How the program ends after all that was read.
  [[nodiscard]] int code() const { return code_; }

 private:
  void explain(const RgbImage& explanation, const std::filesystem::path& image, ordered_json& line) {
    const auto written =
        png_of(explanation).and_then([&](const std::string& png) { return folder_->write(image, png); });
    if (written) {
      line["explanation"] = written->string();
    } else {
      code_ = report(written.error());
    }
  }

  TagDetector detector_;
  double min_margin_;
  std::optional<ExplanationFolder> folder_;
  int code_ = number(ExitCode::kWell);
};

}  // namespace

int detect_tags(const DetectOptions& options, const DetectorConfig& config) {
  Result<TagDetector> detector = TagDetector::open({.family = options.family, .min_margin = config.min_margin});
  if (!detector) return report({detector.error().code, "--family: " + detector.error().message});
  auto folder = ExplanationFolder::open_if_named(options.explain, options.images);
  if (!folder) return report(folder.error());
  TagReader reader(std::move(*detector), config.min_margin, std::move(*folder));
  for (const std::filesystem::path& image : options.images) {
    fmt::print("{}\n", reader.line_for(image).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }
  return reader.code();
}

}  // namespace tripoint
