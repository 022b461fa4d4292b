#include "app/detect_command.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "app/detect_tags.h"
#include "app/detector_settings.h"
#include "app/exit_code.h"
#include "app/explanation_folder.h"
#include "capture/image_file.h"
#include "explain/explanation.h"
#include "explain/png_encoder.h"
#include "explain/why.h"
#include "line/detect/led_detector.h"
#include "line/detect/sphere_detector.h"

namespace tripoint {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const ImagePoint& point) {
  const Matrix2& c = point.covariance_px2;
  return {{"id", 0},  // LEDs have no identity in a single picture
          {"u_px", point.at.u_px},
          {"v_px", point.at.v_px},
          {"covariance_px2", {{c(0, 0), c(0, 1)}, {c(1, 0), c(1, 1)}}},
          {"peak", point.peak},
          {"saturated", point.saturated}};
}

ordered_json as_json(const CandidateLog& log, const DetectorSettings& settings, int width_px) {
  ordered_json candidates = ordered_json::array();
  for (const Candidate& candidate : log) {
    candidates.push_back({{"number", candidates.size() + 1},
                          {"cause", name(candidate.cause)},
                          {"u_px", candidate.at.u_px},
                          {"v_px", candidate.at.v_px},
                          {"why", why(candidate, settings, width_px)}});
  }
  return candidates;
}

Result<std::filesystem::path> write_explanation(const Explained& explained, const std::filesystem::path& image,
                                                ExplanationFolder& folder) {
  return png_of(explanation_of(explained, image.filename().string())).and_then([&](const std::string& png) {
    return folder.write(image, png);
  });
}

/// The detector that the configuration chooses.
class ChosenDetector {
 public:
  explicit ChosenDetector(const DetectorSettings& settings) : detector_(detector_of(settings)) {}

  Detection detect(const Picture& picture) {
    if (auto* const spheres = std::get_if<SphereDetector>(&detector_)) return spheres->detect(picture);
    return std::get<LedDetector>(detector_).detect(picture, Forecast{});
  }
  [[nodiscard]] const CandidateLog& candidates() const {
    return std::visit([](const auto& detector) -> const CandidateLog& { return detector.candidates(); }, detector_);
  }

 private:
  using Either = std::variant<LedDetector, SphereDetector>;
  static Either detector_of(const DetectorSettings& settings) {
    if (const auto* const sphere = std::get_if<SphereSettings>(&settings)) return SphereDetector(*sphere);
    return LedDetector(std::get<LedDetectorSettings>(settings));
  }

  Either detector_;
};

/// Looks at one image after the other.
class PictureReader {
 public:
  PictureReader(const DetectorSettings& settings, std::optional<ExplanationFolder> folder)
      : settings_(settings), detector_(settings), folder_(std::move(folder)) {}

  ordered_json line_for(const std::filesystem::path& image) {
    const Result<LoadedImage> loaded = LoadedImage::load(image);
    if (!loaded) {
      code_ = number(ExitCode::kUsage);
      return {{"image", image.string()}, {"error", loaded.error().message}};
    }
    const Picture& picture = loaded->picture();
    const bool coloured = picture.v.data != nullptr;  // a grey picture shows no red light
    const Detection detection = coloured ? detector_.detect(picture) : Detection{};
    ordered_json points = ordered_json::array();
    for (const ImagePoint& point : detection.points) points.push_back(as_json(point));
    ordered_json line = {{"image", image.string()},
                         {"looked_at", coloured},
                         {"cut", detection.health.candidates_cut},
                         {"points", points}};
    if (folder_) {
      const CandidateLog log = coloured ? detector_.candidates() : CandidateLog{};
      explain({.picture = picture, .log = log, .detection = detection, .settings = settings_}, image, line);
    }
    return line;
  }

  /// How the program ends after all that was read.
  [[nodiscard]] int code() const { return code_; }

 private:
  void explain(const Explained& explained, const std::filesystem::path& image, ordered_json& line) {
    line["candidates"] = as_json(explained.log, settings_, explained.picture.size.width_px);
    const auto written = write_explanation(explained, image, *folder_);
    if (written) {
      line["explanation"] = written->string();
    } else {
      code_ = report(written.error());
    }
  }

  DetectorSettings settings_;
  ChosenDetector detector_;
  std::optional<ExplanationFolder> folder_;
  int code_ = number(ExitCode::kWell);
};

}  // namespace

int detect_command(const DetectOptions& options) {
  Result<Config> config = options.config.empty() ? Result<Config>(Config{}) : load_config(options.config, {});
  if (!config) return report(config.error());
  if (options.detector == "led") config->detector.kind = ConfiguredDetector::kLed;
  if (options.detector == "sphere") config->detector.kind = ConfiguredDetector::kSphere;
  if (options.detector == "apriltag") config->detector.kind = ConfiguredDetector::kAprilTag;
  if (config->detector.kind == ConfiguredDetector::kAprilTag) return detect_tags(options, config->detector);
  auto folder = ExplanationFolder::open_if_named(options.explain, options.images);
  if (!folder) return report(folder.error());
  PictureReader reader(detector_settings(config->detector), std::move(*folder));
  for (const std::filesystem::path& image : options.images) {
    fmt::print("{}\n", reader.line_for(image).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }
  return reader.code();
}

}  // namespace tripoint
