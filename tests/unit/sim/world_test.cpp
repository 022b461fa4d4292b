#include "sim/world.h"

#include <functional>
#include <string>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

struct WrongSetting {
  std::string name;
  std::function<void(SimulationSettings&)> spoil;
};

TEST(WorldTest, SettingsThatNoCameraHasAreRefusedByName) {
  const std::vector<WrongSetting> cases{
      {"size", [](auto& s) { s.rig = default_rig({.width_px = 630, .height_px = 480}); }},
      {"size", [](auto& s) { s.rig.cameras.right.size.height_px = 240; }},
      {"rate_hz", [](auto& s) { s.rate_hz = 0.0; }},
      {"exposure", [](auto& s) { s.exposure = Duration{-1}; }},
      {"cameras.gain", [](auto& s) { s.gain = -1; }},
      {"cameras.gain", [](auto& s) { s.gain = 256; }},
      {"line_time", [](auto& s) { s.line_time = std::chrono::microseconds{80}; }},  // 38 ms at 30 Hz
      {"mjpeg_quality", [](auto& s) { s.mjpeg_quality = 101; }},
      {"read_noise", [](auto& s) { s.sensor.read_noise = -0.1; }},
      {"full_well", [](auto& s) { s.sensor.full_well_electrons = 0.0; }},
      {"optical_sigma", [](auto& s) { s.sensor.optical_sigma_px = 0.0; }},
      {"hot_pixel_share", [](auto& s) { s.sensor.hot_pixel_share = 1.5; }},
      {"gamma", [](auto& s) { s.tone.gamma = 0.0; }},
      {"tags", [](auto& s) { s.scene.tags.emplace_back().cells.light.assign(99, true); }},
      {"tags",
       [](auto& s) { s.scene.tags = {{.cells = {.across = 17, .total = 17, .light = std::vector(289, true)}}}; }},
      {"tags", [](auto& s) { s.scene.tags = {{.cells = {.light = std::vector(100, true)}, .size_mm = 0.0}}; }},
      {"trajectory", [](auto& s) { s.trajectory.period = Duration{0}; }},
  };
  for (const WrongSetting& wrong : cases) {
    SimulationSettings settings;
    wrong.spoil(settings);
    const Result<SimulatedWorld> refused = SimulatedWorld::create(settings);
    ASSERT_FALSE(refused) << wrong.name;
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange) << wrong.name;
    EXPECT_NE(refused.error().message.find(wrong.name), std::string::npos) << refused.error().message;
  }
}

TEST(WorldTest, TheHighestGainIsAWorld) {
  SimulationSettings settings;
  settings.gain = 255;
  EXPECT_TRUE(SimulatedWorld::create(settings));
}

TEST(WorldTest, CamerasAtOnePlaceAreNoRig) {
  SimulationSettings settings;
  settings.rig.right_from_left.translation().setZero();
  const Result<SimulatedWorld> refused = SimulatedWorld::create(settings);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kDegenerate);
}

TEST(WorldTest, WallHasItsReflectanceTimesTheWhiteLevel) {
  SimulationSettings settings;
  settings.scene.white_level = 0.06;
  settings.scene.surfaces = {{.reflectance = {0.5, 0.4, 0.25}, .texture = 0.0}};
  const SimulatedWorld world = world_of(settings);
  const std::vector<float>& levels = world.background(Side::kLeft);
  EXPECT_FLOAT_EQ(levels[0], 0.030F);
  EXPECT_FLOAT_EQ(levels[1], 0.024F);
  EXPECT_FLOAT_EQ(levels[641], 0.015F);
}

TEST(WorldTest, AKnockedCameraStandsTurnedAboutItsLensInTheSecondRound) {
  SimulationSettings settings;
  settings.trajectory = three_circles();
  settings.knock = bumped_camera();
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  for (const double since_1970_s : {5.0, 11.9, 12.1, 23.9, 24.1, 36.0 + 5.0, 36.0 + 12.1}) {
    const Duration at = duration_from_seconds(since_1970_s);
    const double round = std::fmod(since_1970_s, 36.0) / kRound_s;
    const double turned_deg = round >= 1.0 && round < 2.0 ? 0.1 : 0.0;
    const Isometry3 moved = world.camera_from_reference(Side::kRight, at) * world.rig().camera_from_rig.right.inverse();
    const Eigen::AngleAxisd turn(moved.linear());
    EXPECT_NEAR(turn.angle() * turn.axis().y() * 180.0 / std::numbers::pi, turned_deg, 1e-9) << since_1970_s;
    EXPECT_LT(moved.translation().norm(), 1e-9);
    EXPECT_TRUE(world.camera_from_reference(Side::kLeft, at).isApprox(world.rig().camera_from_rig.left));
  }
}

TEST(WorldTest, TextureStaysWithinItsAmplitude) {
  const SimulatedWorld world = world_of(SimulationSettings{});
  const auto [low, high] = std::ranges::minmax(world.background(Side::kRight));
  EXPECT_GE(low, 0.025F * 0.9F - 1e-6F);
  EXPECT_LE(high, 0.025F * 1.1F + 1e-6F);
  EXPECT_GT(high - low, 0.003F);
}

}  // namespace
}  // namespace tripoint
