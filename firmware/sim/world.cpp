#include "sim/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace tripoint {
namespace {

constexpr int kJpegBlock = 16;
constexpr int kMaxSize_px = 8192;

bool is_size(ImageSize size) {
  const auto fits = [](int px) { return px > 0 && px <= kMaxSize_px && px % kJpegBlock == 0; };
  return fits(size.width_px) && fits(size.height_px);
}

/// What is wrong with size, rate, exposure or line time, or "".
std::string wrong_timing(const SimulationSettings& settings) {
  const ImageSize size = settings.rig.cameras.left.size;
  if (!is_size(size) || !(size == settings.rig.cameras.right.size)) return "size: must be multiples of 16, both equal";
  if (!(settings.rate_hz > 0.0 && settings.rate_hz <= 1000.0)) return "rate_hz: must be above 0, up to 1000";
  if (settings.exposure < Duration::zero() || settings.exposure > std::chrono::seconds{1}) {
    return "exposure: must be 0 to 1 s";
  }
  if (settings.line_time < Duration::zero() || seconds(settings.line_time) * size.height_px * settings.rate_hz > 1.0) {
    return "line_time: must be 0 up to the frame period over the height";
  }
  return {};
}

/// The name of the first setting that no camera has, or "".
std::string wrong_setting(const SimulationSettings& settings) {
  if (std::string timing = wrong_timing(settings); !timing.empty()) return timing;
  if (settings.mjpeg_quality < 1 || settings.mjpeg_quality > 100) return "mjpeg_quality: must be 1 to 100";
  if (!(settings.sensor.read_noise >= 0.0 && settings.sensor.read_noise <= 1.0)) return "read_noise: must be 0 to 1";
  if (!(settings.sensor.full_well_electrons >= 1.0)) return "full_well_electrons: must be at least 1";
  if (!(settings.sensor.optical_sigma_px >= 0.3)) return "optical_sigma_px: must be at least 0.3";
  if (settings.trajectory.period <= Duration::zero()) return "trajectory: its period must be above 0";
  return {};
}

/// Where a surface covers the pixel: everywhere without an outline, else inside the disc's picture.
struct Cover {
  bool everywhere = true;
  RawPixel center;
  double radius_px = 0.0;

  [[nodiscard]] double share_at(int x, int y) const {
    if (everywhere) return 1.0;
    const double distance_px = std::hypot(x - center.u_px, y - center.v_px);
    return std::clamp(radius_px - distance_px + 0.5, 0.0, 1.0);
  }
};

Cover cover_of(const Surface& surface, const CameraModel& camera, const Isometry3& camera_from_rig) {
  if (!surface.outline) return {};
  const Vec3 in_camera_mm = camera_from_rig * surface.outline->center_in_reference_mm;
  const Result<RawPixel> center = projected(camera, in_camera_mm);
  if (!center) return {.everywhere = false, .center = {}, .radius_px = -1.0};
  return {.everywhere = false,
          .center = *center,
          .radius_px = surface.outline->radius_mm * camera.focal_px.x() / in_camera_mm.z()};
}

/// A gentle pattern between -1 and 1.
double pattern(double x_px, double y_px, double period_px) {
  const double k = 2.0 * std::numbers::pi / period_px;
  return 0.5 * (std::sin(k * (x_px + 0.3 * y_px)) + std::cos(k * (0.8 * y_px - 0.2 * x_px)));
}

std::vector<float> painted_background(const Scene& scene, const CameraModel& camera, const Isometry3& camera_from_rig) {
  const auto width = static_cast<std::size_t>(camera.size.width_px);
  std::vector<float> levels(width * static_cast<std::size_t>(camera.size.height_px));
  for (const Surface& surface : scene.surfaces) {
    const Cover cover = cover_of(surface, camera, camera_from_rig);
    for (int y = 0; y < camera.size.height_px; ++y) {
      float* row = levels.data() + static_cast<std::size_t>(y) * width;
      for (int x = 0; x < camera.size.width_px; ++x) {
        const double share = cover.share_at(x, y);
        if (share <= 0.0) continue;
        const double texture = 1.0 + surface.texture * pattern(x, y, surface.texture_period_px);
        const double level = scene.white_level * surface.reflectance[bayer_channel(x, y)] * texture;
        row[x] += static_cast<float>(share * (level - static_cast<double>(row[x])));
      }
    }
  }
  return levels;
}

}  // namespace

SimulatedWorld::SimulatedWorld(SimulationSettings settings, TimePoint start, Rig rig)
    : settings_(std::move(settings)),
      start_(start),
      rig_(std::move(rig)),
      noise_(settings_.seed, static_cast<std::size_t>(rig_.cameras.left.size.width_px)) {
  for (const Side side : kBothSides) {
    backgrounds_[side] = painted_background(settings_.scene, rig_.cameras[side], rig_.camera_from_rig[side]);
  }
}

Result<SimulatedWorld> SimulatedWorld::create(const SimulationSettings& settings, TimePoint start) {
  const std::string wrong = wrong_setting(settings);
  if (!wrong.empty()) return failure(ErrorCode::kOutOfRange, "simulation: " + wrong);
  Result<Rig> rig = rig_of(settings.rig);
  if (!rig) return tl::make_unexpected(rig.error());
  return SimulatedWorld(settings, start, *std::move(rig));
}

}  // namespace tripoint
