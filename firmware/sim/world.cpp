#include "sim/world.h"

#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "sim/tag_cover.h"

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

/// What is wrong with the sensor, or "".
std::string wrong_sensor(const SensorModel& sensor) {
  if (!(sensor.read_noise >= 0.0 && sensor.read_noise <= 1.0)) return "read_noise: must be 0 to 1";
  if (!(sensor.full_well_electrons >= 1.0)) return "full_well_electrons: must be at least 1";
  if (!(sensor.optical_sigma_px >= 0.3)) return "optical_sigma_px: must be at least 0.3";
  if (!(sensor.hot_pixel_share >= 0.0 && sensor.hot_pixel_share <= 1.0)) {
    return "hot_pixel_share: must be 0 to 1";
  }
  return {};
}

/// What is wrong with a printed tag, or "".
std::string wrong_tag(const PrintedTag& tag) {
  const TagCells& cells = tag.cells;
  if (!(tag.size_mm > 0.0)) return "tags: their size must be above 0";
  if (cells.across < 1 || cells.total < cells.across || cells.total > kMostTagCells) {
    return "tags: their cells must be 1 to " + std::to_string(kMostTagCells) + " across";
  }
  const auto total = static_cast<std::size_t>(cells.total);
  if (cells.light.size() != total * total) {
    return "tags: their cells must fill a square";
  }
  return {};
}

/// The name of the first setting that no camera has, or "".
std::string wrong_setting(const SimulationSettings& settings) {
  if (std::string timing = wrong_timing(settings); !timing.empty()) return timing;
  if (settings.gain < kSimulatedGains.lowest || settings.gain > kSimulatedGains.highest) {
    return "cameras.gain: simulated cameras permit 0 to 255";
  }
  if (settings.mjpeg_quality < 1 || settings.mjpeg_quality > 100) return "mjpeg_quality: must be 1 to 100";
  if (std::string sensor = wrong_sensor(settings.sensor); !sensor.empty()) return sensor;
  if (!(settings.tone.gamma >= 0.1 && settings.tone.gamma <= 10.0)) return "tone: its gamma must be 0.1 to 10";
  for (const PrintedTag& tag : settings.scene.tags) {
    if (std::string wrong = wrong_tag(tag); !wrong.empty()) return wrong;
  }
  if (settings.trajectory.period <= Duration::zero()) return "trajectory: its period must be above 0";
  return {};
}

}  // namespace

SimulatedWorld::SimulatedWorld(SimulationSettings settings, TimePoint start, Rig rig)
    : settings_(std::move(settings)),
      start_(start),
      rig_(std::move(rig)),
      noise_(settings_.seed, static_cast<std::size_t>(rig_.cameras.left.size.width_px)) {
  const double blur_px = settings_.sensor.optical_sigma_px;
  for (const Side side : kBothSides) {
    const CameraModel& camera = rig_.cameras[side];
    figures_[side] = figures_of(settings_.scene, camera, rig_.camera_from_rig[side], blur_px);
    backgrounds_[side] = painted(settings_.scene, figures_[side], camera.size, normal_);
    if (settings_.scene.board) {
      const BoardView view{.camera = camera, .camera_from_reference = rig_.camera_from_rig[side], .blur_px = blur_px};
      paint_chessboard(backgrounds_[side], *settings_.scene.board, view, settings_.scene.white_level, normal_);
    }
    hot_pixels_[side] =
        tripoint::hot_pixels(settings_.sensor, camera.size, 2 * settings_.seed + (side == Side::kLeft ? 0 : 1));
    for (const std::size_t pixel : hot_pixels_[side]) {
      backgrounds_[side][pixel] += static_cast<float>(settings_.sensor.hot_pixel_level);
    }
  }
}

Isometry3 SimulatedWorld::camera_from_reference(Side side, Duration since_1970) const {
  const std::optional<Knock>& knock = settings_.knock;
  const Duration phase = since_1970 % settings_.trajectory.period;
  if (!knock || knock->side != side || phase < knock->from || phase >= knock->to) return rig_.camera_from_rig[side];
  const double angle_rad = knock->turn_rad.norm();
  return Eigen::AngleAxisd(angle_rad, knock->turn_rad.stableNormalized()) * rig_.camera_from_rig[side];
}

Knock bumped_camera() {
  constexpr double kTenthOfADegree_rad = 0.1 / 180.0 * std::numbers::pi;
  return {.side = Side::kRight,
          .turn_rad = {0.0, kTenthOfADegree_rad, 0.0},
          .from = duration_from_seconds(kRound_s),
          .to = duration_from_seconds(2.0 * kRound_s)};
}

Result<SimulatedWorld> SimulatedWorld::create(const SimulationSettings& settings, TimePoint start) {
  const std::string wrong = wrong_setting(settings);
  if (!wrong.empty()) return failure(ErrorCode::kOutOfRange, "simulation: " + wrong);
  Result<Rig> rig = rig_of(settings.rig);
  if (!rig) return tl::make_unexpected(rig.error());
  return SimulatedWorld(settings, start, *std::move(rig));
}

}  // namespace tripoint
