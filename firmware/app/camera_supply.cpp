#include "app/camera_supply.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "devices/camera_finder.h"
#include "devices/v4l2_camera.h"
#include "devices/v4l2_driver.h"
#include "recording/recorded_camera.h"
#include "sim/simulated_camera.h"
#include "sim/trajectory.h"
#include "sim/world.h"
#include "tags/tag_print.h"

namespace tripoint {
namespace {

PixelFormat pixel_format(ConfiguredFormat format) {
  switch (format) {
    case ConfiguredFormat::kMjpeg:
      return PixelFormat::kMjpeg;
    case ConfiguredFormat::kGrey:
      return PixelFormat::kGrey;
    case ConfiguredFormat::kYuyv:
      break;
  }
  return PixelFormat::kYuyv;
}

Trajectory trajectory_of(Scenario scenario) {
  switch (scenario) {
    case Scenario::kPaperLinear:
      return paper_linear();
    case Scenario::kStaticVolume:
      return static_volume();
    case Scenario::kScout:
      return scout();
    case Scenario::kBumpedCamera:
      return three_circles();
    case Scenario::kPaperCircular:
      break;
  }
  return paper_circular();
}

constexpr double kUsualExposure_us = 2000.0;  ///< for which the scene's levels hold
constexpr double kGainSteps = 64.0;           ///< of cameras.gain, that double the light

/// Light is proportional to the exposure; a gain lifts the noise as well.
void expose(SimulationSettings& settings, const CamerasConfig& cameras) {
  const double gain = 1.0 + cameras.measuring.gain / kGainSteps;
  const double light = gain * static_cast<double>(cameras.measuring.exposure.count()) / kUsualExposure_us;
  for (LightSource& source : settings.scene.lights) source.peak *= light;
  settings.scene.white_level *= light;
  settings.sensor.read_noise = std::min(1.0, gain * settings.sensor.read_noise);
  settings.sensor.full_well_electrons = std::max(1.0, settings.sensor.full_well_electrons / gain);
}

/// Of the target's LEDs; of a target without LEDs one at the origin.
std::vector<Vec3> led_places_mm(const Target& target) {
  std::vector<Vec3> places_mm;
  for (const TargetPoint& point : target.points) places_mm.push_back(point.in_target_mm);
  if (places_mm.empty()) places_mm.emplace_back(Vec3::Zero());
  return places_mm;
}

/// Like an LED, within the usual working volume, beside the scenarios' ways.
void add_red_lamps(Scene& scene, int count) {
  const std::array<Vec3, 4> places_mm{Vec3(100.0, -40.0, 420.0), Vec3(-120.0, 20.0, 400.0), Vec3(60.0, 120.0, 390.0),
                                      Vec3(-20.0, -130.0, 440.0)};
  for (int i = 0; i < count; ++i) scene.lights.push_back(fixed_lamp(scene, places_mm[static_cast<std::size_t>(i)]));
}

/// On paper, where its corners say.
Result<PrintedTag> printed(const TargetTag& tag, std::string_view family) {
  const auto& corners_mm = tag.corners_mm;  // lower left, lower right, upper right, upper left
  const Vec3 right_mm = corners_mm[1] - corners_mm[0];
  const Vec3 down_mm = corners_mm[0] - corners_mm[3];
  return tag_print(family, tag.id).map([&](const TagCells& cells) {
    PrintedTag print{.id = tag.id, .cells = cells, .size_mm = right_mm.norm()};
    print.target_from_tag.linear() << right_mm.normalized(), down_mm.normalized(), right_mm.cross(down_mm).normalized();
    print.target_from_tag.translation() = 0.5 * (corners_mm[0] + corners_mm[2]);
    return print;
  });
}

/// The target's LEDs or tags before a wall.
Result<Scene> scene_of(const MeasuredTarget& target, const SimulationConfig& wanted) {
  if (target.target.tags.empty()) return led_scene(led_places_mm(target.target), wanted.led_peak);
  Scene scene;
  for (const TargetTag& tag : target.target.tags) {
    Result<PrintedTag> print = printed(tag, target.tag_family);
    if (!print) return tl::make_unexpected(print.error());
    scene.tags.push_back(*std::move(print));
  }
  return scene;
}

Result<SimulationSettings> simulation_settings(const Config& config, const MeasuredTarget& target) {
  const SimulationConfig& wanted = config.simulation;
  const Result<Trajectory> trajectory = wanted.trajectory_file.empty()
                                            ? Result<Trajectory>(trajectory_of(wanted.scenario))
                                            : load_trajectory(wanted.trajectory_file);
  if (!trajectory) return tl::make_unexpected(named_by(config, "simulation.trajectory_file", trajectory.error()));
  SimulationSettings settings;
  settings.trajectory = *trajectory;
  if (wanted.trajectory_file.empty() && wanted.scenario == Scenario::kBumpedCamera) settings.knock = bumped_camera();
  settings.rig = default_rig(config.cameras.size);
  settings.format = pixel_format(config.cameras.format);
  settings.rate_hz = config.cameras.rate_hz;
  settings.exposure = config.cameras.measuring.exposure;
  settings.gain = config.cameras.measuring.gain;
  settings.line_time = duration_from_seconds(config.timing.line_time_us * 1e-6);
  settings.clocks.left = {.phase = Duration{0},
                          .drift_ppm = wanted.clock_drift_ppm / 2.0,
                          .stamp_jitter = duration_from_seconds(wanted.stamp_jitter_us * 1e-6)};
  settings.clocks.right = settings.clocks.left;
  settings.clocks.right.phase = duration_from_seconds(wanted.right_phase_ms * 1e-3);
  settings.clocks.right.drift_ppm = -wanted.clock_drift_ppm / 2.0;
  settings.seed = wanted.seed;
  Result<Scene> scene = scene_of(target, wanted);
  if (!scene) return tl::make_unexpected(named_by(config, "target.file", scene.error()));
  settings.scene = *std::move(scene);
  add_red_lamps(settings.scene, wanted.red_lamps);
  if (config.datum) settings.scene.lights.push_back(fixed_lamp(settings.scene, config.datum->position_mm));
  settings.scene.white_level = wanted.white_level;
  expose(settings, config.cameras);
  return settings;
}

LitShare lit_share_of(const SimulatedLeds& leds, const Clock& clock, SimulatedLines lines) {
  if (lines == SimulatedLines::kStuckLit) return {};
  if (lines == SimulatedLines::kStuckOut) return [](std::size_t, Duration, Duration) { return 0.0; };
  return [&leds, &clock](std::size_t line, Duration from_1970, Duration to_1970) {
    const Duration since_start = -clock.utc_offset();
    return leds.lit_share(line, TimePoint{from_1970 + since_start}, TimePoint{to_1970 + since_start});
  };
}

Result<PerSide<OpenCamera>> simulated_cameras(const SimulationSettings& settings, const Clock& clock) {
  return SimulatedWorld::create(settings, clock.now()).map([&](SimulatedWorld&& made) {
    // shared: both cameras look at one world, for as long as either may be opened anew
    const auto world = std::make_shared<const SimulatedWorld>(std::move(made));
    const auto open = [world, &clock](Side side) -> OpenCamera {
      return [world, &clock, side]() -> Result<std::unique_ptr<Camera>> {
        return SimulatedCamera::open(*world, side, clock, sleeping_by(clock));
      };
    };
    return PerSide<OpenCamera>{open(Side::kLeft), open(Side::kRight)};
  });
}

Result<PerSide<OpenCamera>> recorded_cameras(const Config& config, const Clock& clock) {
  const Playback playback{.clock = clock, .wait_until = sleeping_by(clock), .start = clock.now()};
  PerSide<OpenCamera> cameras;
  for (const Side side : kBothSides) {
    Result<OpenCamera> opener = RecordedCamera::opener(config.recording.folder, side, playback);
    if (!opener) return tl::make_unexpected(named_by(config, "recording.folder", opener.error()));
    cameras[side] = std::move(*opener);
  }
  return cameras;
}

V4l2Settings v4l2_settings(const CamerasConfig& config, Side side, const FoundCamera& found, Duration line_time) {
  return {.side = side,
          .node = found.node,
          .port = found.port,
          .serial = found.serial,
          .format = pixel_format(config.format),
          .size = config.size,
          .rate_hz = config.rate_hz,
          .exposure = config.measuring.exposure,
          .gain = config.measuring.gain,
          .white_balance_k = config.white_balance_k,
          .focus = config.focus,
          .line_time = line_time};
}

/// Finds the camera anew at each opening: its node may have changed while it was away.
PerSide<OpenCamera> real_cameras(const Config& config, const Clock& clock) {
  const auto driver = std::make_shared<KernelV4l2Driver>();  // shared: both cameras and every later opening use it
  const Duration line_time = duration_from_seconds(config.timing.line_time_us * 1e-6);
  const auto open = [driver, &clock, cameras_config = config.cameras, line_time](Side side) -> OpenCamera {
    return [=, &clock]() -> Result<std::unique_ptr<Camera>> {
      const CameraBinding& binding = cameras_config.bindings[side];
      const CameraWanted wanted{.port = binding.port, .serial = binding.serial, .device = binding.device};
      return camera_that_fits(cameras(*driver), wanted, std::string("camera ") + std::string(name(side)))
          .and_then([&](const FoundCamera& found) {
            return V4l2Camera::open(v4l2_settings(cameras_config, side, found, line_time), *driver, clock);
          });
    };
  };
  return {open(Side::kLeft), open(Side::kRight)};
}

}  // namespace

Result<PerSide<OpenCamera>> camera_supply(const Config& config, const MeasuredTarget& target, const Clock& clock,
                                          const SimulatedLeds* switched) {
  switch (config.cameras.source) {
    case CameraSource::kSimulation:
      return simulation_settings(config, target).and_then([&](SimulationSettings settings) {
        if (switched != nullptr) settings.lit_share = lit_share_of(*switched, clock, config.simulation.led_lines);
        return simulated_cameras(settings, clock);
      });
    case CameraSource::kRecording:
      return recorded_cameras(config, clock);
    case CameraSource::kV4l2:
      break;
  }
  return real_cameras(config, clock);
}

Result<PerSide<OpenCamera>> simulated_cameras_showing(const Config& config, const Clock& clock,
                                                      const Vec3& place_in_reference_mm) {
  return simulation_settings(config, MeasuredTarget{}).and_then([&](SimulationSettings settings) {
    settings.trajectory.reference_from_target = [place_in_reference_mm](double /*second*/) {
      Isometry3 pose = Isometry3::Identity();
      pose.translation() = place_in_reference_mm;
      return pose;
    };
    return simulated_cameras(settings, clock);
  });
}

Result<PerSide<OpenCamera>> cameras_before_board(const Config& config, const Clock& clock) {
  if (config.cameras.source != CameraSource::kSimulation) return camera_supply(config, MeasuredTarget{}, clock);
  return simulation_settings(config, MeasuredTarget{}).and_then([&](SimulationSettings settings) {
    settings.scene.lights.clear();
    settings.scene.board.emplace().reference_from_board.translation() =
        0.5 * (config.volume.min_mm + config.volume.max_mm);
    return simulated_cameras(settings, clock);
  });
}

}  // namespace tripoint
