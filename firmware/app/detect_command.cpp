#include "app/detect_command.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/detector_settings.h"
#include "app/exit_code.h"
#include "capture/image_file.h"
#include "line/detect/led_detector.h"

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

ordered_json detected(const std::filesystem::path& image, LedDetector& detector) {
  const Result<LoadedImage> loaded = LoadedImage::load(image);
  if (!loaded) return {{"image", image.string()}, {"error", loaded.error().message}};
  ordered_json points = ordered_json::array();
  if (loaded->picture().v.data != nullptr) {  // a grey picture shows no red light
    for (const ImagePoint& point : detector.detect(loaded->picture(), Forecast{}).points) {
      points.push_back(as_json(point));
    }
  }
  return {{"image", image.string()}, {"points", points}};
}

}  // namespace

int detect_command(const std::vector<std::filesystem::path>& images, const std::filesystem::path& config) {
  const Result<Config> loaded = config.empty() ? Result<Config>(Config{}) : load_config(config, {});
  if (!loaded) return report(loaded.error());
  LedDetector detector(led_detector_settings(loaded->detector));
  bool all_read = true;
  for (const std::filesystem::path& image : images) {
    const ordered_json line = detected(image, detector);
    all_read = all_read && !line.contains("error");
    fmt::print("{}\n", line.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }
  return number(all_read ? ExitCode::kWell : ExitCode::kUsage);
}

}  // namespace tripoint
