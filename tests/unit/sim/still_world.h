// Worlds for the tests: no noise, and light whose closed form is known.
#pragma once

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint {

inline SimulatedWorld world_of(const SimulationSettings& settings, TimePoint start = TimePoint{}) {
  Result<SimulatedWorld> world = SimulatedWorld::create(settings, start);
  EXPECT_TRUE(world) << world.error().message;
  return *std::move(world);
}

/// A target that moves with constant velocity and is at `place_mm` at phase 500 s.
inline Trajectory straight(const Vec3& place_mm, const Vec3& velocity_mm_per_s) {
  return {.period = std::chrono::seconds{1000}, .reference_from_target = [=](double phase_s) {
            Isometry3 pose = Isometry3::Identity();
            pose.translation() = place_mm + (phase_s - 500.0) * velocity_mm_per_s;
            return pose;
          }};
}
inline constexpr Duration kHalfWay{std::chrono::seconds{500}};

/// One white light without halo before a black wall, no noise, an instantaneous exposure of all rows at once.
inline SimulationSettings bare_settings() {
  SimulationSettings settings;
  settings.trajectory = straight({0.0, 0.0, 400.0}, Vec3::Zero());
  settings.scene = led_scene({Vec3::Zero()}, 0.8);
  settings.scene.lights[0].color = {1.0, 1.0, 1.0};
  settings.scene.lights[0].halo_share = 0.0;
  settings.scene.surfaces.clear();
  settings.sensor = {.read_noise = 0.0, .full_well_electrons = 1e30};
  settings.exposure = Duration{0};
  settings.line_time = Duration{0};
  return settings;
}

/// Energy, centre and variance of a picture given as value(x, y), over a window.
struct PictureMoments {
  double energy = 0.0;
  RawPixel center;
  Vec2 variance_px2 = Vec2::Zero();
};

struct Window {
  int left = 0;
  int top = 0;
  int right = 639;
  int bottom = 479;
};

inline Window around(const RawPixel& at, int reach_px) {
  const int x = static_cast<int>(std::lround(at.u_px));
  const int y = static_cast<int>(std::lround(at.v_px));
  return {x - reach_px, y - reach_px, x + reach_px, y + reach_px};
}

inline PictureMoments moments_of(const std::function<double(int, int)>& value, const Window& window) {
  PictureMoments sums;
  Vec2 first = Vec2::Zero();
  Vec2 second = Vec2::Zero();
  for (int y = window.top; y <= window.bottom; ++y) {
    for (int x = window.left; x <= window.right; ++x) {
      const double level = value(x, y);
      sums.energy += level;
      first += level * Vec2(x, y);
      second += level * Vec2(x, y).cwiseAbs2();
    }
  }
  first /= sums.energy;
  sums.center = {.u_px = first.x(), .v_px = first.y()};
  sums.variance_px2 = second / sums.energy - first.cwiseAbs2();
  return sums;
}

/// Of the light that falls on the sensor.
inline PictureMoments light_moments(const FrameRenderer& renderer, const Window& window = {}) {
  return moments_of(
      [&](int x, int y) { return static_cast<double>(renderer.light().row(y)[static_cast<std::size_t>(x)]); }, window);
}

}  // namespace tripoint
