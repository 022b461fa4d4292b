#include "sim/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/clutter_stage.h"
#include "sim/default_rig.h"

namespace tripoint {
namespace {

constexpr double kNearest_mm = 350.0;
constexpr double kFarthest_mm = 800.0;
const std::array<Vec3, 4> kLeds_mm{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0),
                                   Vec3(50.0, 20.0, -40.0)};

/// The ranges are those of webcams that were measured or are sold: 6 to 12 thousand electrons, sharp to soft lenses.
SensorModel drawn_sensor(Draws draws, ImageSize size) {
  SensorModel sensor;
  sensor.read_noise = draws.scaled({0.001, 0.006});
  sensor.full_well_electrons = draws.scaled({5000.0, 12'000.0});
  sensor.optical_sigma_px = draws.even(0.6, 1.0) * (size.width_px > 1000 ? 1.3 : 1.0);
  if (draws.chance(0.3)) sensor.hot_pixel_share = draws.scaled({1e-5, 1e-4});
  sensor.hot_pixel_level = draws.even(0.1, 0.8);
  return sensor;
}

/// Somewhere both cameras look, turned at will about the optical axis and up to 43 degrees away from it.
Isometry3 drawn_pose(Draws& draws) {
  const double z_mm = draws.even(kNearest_mm, kFarthest_mm);
  const double spread = draws.chance(0.12) ? 1.6 : 1.0;  // sometimes partly outside the picture
  const double x_mm = draws.even(-0.28, 0.28) * z_mm * spread;
  const double y_mm = draws.even(-0.2, 0.2) * z_mm;
  const double roll_rad = draws.even(-std::numbers::pi, std::numbers::pi);
  const double tilt_rad = draws.even(-0.75, 0.75);
  const double axis_rad = draws.even(0.0, std::numbers::pi);
  Isometry3 pose = Isometry3::Identity();
  pose.translate(Vec3(x_mm, y_mm, z_mm));
  pose.rotate(Eigen::AngleAxisd(roll_rad, Vec3::UnitZ()));
  pose.rotate(Eigen::AngleAxisd(tilt_rad, Vec3(std::cos(axis_rad), std::sin(axis_rad), 0.0)));
  return pose;
}

ClutterStage drawn_stage(std::uint64_t seed, const ClutterChoice& choice, double focal_px) {
  ClutterStage stage{.seed = seed, .choice = choice, .focal_px = focal_px};
  Draws draws = stage.draws(ClutterTopic::kTarget);
  stage.white_level = draws.scaled(choice.white_level);
  stage.reference_from_target = drawn_pose(draws);
  const auto fewest = static_cast<std::size_t>(choice.min_leds);
  const auto most = static_cast<std::size_t>(choice.max_leds);
  const std::size_t leds = fewest + draws.index(most - fewest + 1);
  Vec3 middle_mm = Vec3::Zero();
  for (std::size_t i = 0; i < leds; ++i) middle_mm += kLeds_mm[i] / static_cast<double>(leds);
  for (std::size_t i = 0; i < leds; ++i) stage.leds_in_target_mm.emplace_back(kLeds_mm[i] - middle_mm);
  stage.sensor = drawn_sensor(stage.draws(ClutterTopic::kSensor), choice.size);
  return stage;
}

}  // namespace

SimulationSettings clutter_settings(std::uint64_t seed, const ClutterChoice& choice) {
  SimulationSettings settings;
  settings.rig = default_rig(choice.size);
  const ClutterStage stage = drawn_stage(seed, choice, settings.rig.cameras.left.focal_px.mean());
  settings.seed = seed;
  settings.sensor = stage.sensor;
  settings.trajectory = {.period = std::chrono::seconds{12},
                         .reference_from_target = [pose = stage.reference_from_target](double) { return pose; }};
  settings.scene.white_level = stage.white_level;
  settings.scene.surfaces = clutter_surfaces(stage);
  settings.scene.lights = clutter_lights(stage, settings.scene.surfaces);
  return settings;
}

}  // namespace tripoint
