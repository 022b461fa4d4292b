#include "sim/clutter.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "sim/clutter_stage.h"
#include "still_world.h"

namespace tripoint {
namespace {

constexpr std::uint64_t kSeeds = 60;
const ClutterChoice kSmall{.size = {.width_px = 320, .height_px = 240}};

bool is_red(const LightSource& light) { return light.color[1] < 0.2; }

std::vector<LightSource> leds_of(const SimulationSettings& settings) {
  std::vector<LightSource> leds;
  std::ranges::copy_if(settings.scene.lights, std::back_inserter(leds),
                       [](const auto& light) { return light.id != 0; });
  return leds;
}

/// In how many of the seeds a scene has something.
template <typename Has>
std::uint64_t scenes_with(const ClutterChoice& choice, const Has& has) {
  std::uint64_t count = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) count += has(clutter_settings(seed, choice)) ? 1U : 0U;
  return count;
}

TEST(ClutterTest, SameSeedGivesTheSamePictureAndAnotherSeedAnother) {
  const SimulationSettings settings = clutter_settings(5, kSmall);
  const RenderedFrame frame = render(world_of(settings), Side::kLeft, Duration{0});
  EXPECT_EQ(frame.pixels, render(world_of(clutter_settings(5, kSmall)), Side::kLeft, Duration{0}).pixels);
  EXPECT_NE(frame.pixels, render(world_of(clutter_settings(6, kSmall)), Side::kLeft, Duration{0}).pixels);
}

TEST(ClutterTest, TargetHasTheSidesOfItsTriangleAndStandsInTheVolume) {
  std::array<int, 5> of_count{};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SimulationSettings settings = clutter_settings(seed, {.min_leds = 1, .max_leds = 4});
    const std::vector<LightSource> leds = leds_of(settings);
    ++of_count.at(leds.size());
    for (std::size_t i = 0; i < leds.size(); ++i) EXPECT_EQ(leds[i].id, static_cast<int>(i) + 1);
    const auto side_mm = [&](std::size_t a, std::size_t b) { return (leds[a].place_mm - leds[b].place_mm).norm(); };
    if (leds.size() >= 3) {
      EXPECT_NEAR(side_mm(0, 1), 100.0, 1e-9);
      EXPECT_NEAR(side_mm(0, 2), 80.0, 1e-9);
      EXPECT_NEAR(side_mm(1, 2), 60.0, 1e-9);
    }
    const Vec3 middle_mm = target_pose_at(settings.trajectory, Duration{0}).translation();
    EXPECT_GE(middle_mm.z(), 350.0);
    EXPECT_LE(middle_mm.z(), 800.0);
  }
  for (std::size_t leds = 1; leds <= 4; ++leds) EXPECT_GT(of_count[leds], 5) << leds;  // of 15 expected
}

TEST(ClutterTest, EveryLedIsWithinTheChosenPeaksInBothPictures) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const SimulatedWorld world = world_of(clutter_settings(seed, kSmall));
    for (const Side side : kBothSides) {
      for (const LightTruth& light : render(world, side, Duration{0}).truth.lights) {
        if (light.id == 0) continue;
        // Both cameras are 50 mm aside, toed in by 5 degrees: 0.28 x 1.6 of 350 mm aside a depth is 5 % from the
        // reference's z, and a peak between that and its square.
        EXPECT_GT(light.peak, 0.88) << seed;
        EXPECT_LT(light.peak, 3.4) << seed;
      }
    }
  }
}

TEST(ClutterTest, ScenesVaryAsTheDocumentSays) {
  const auto share = [](double probability) { return probability * static_cast<double>(kSeeds); };
  const double slack = 16.0;  // four standard deviations of a share of one half
  const ClutterChoice choice;
  EXPECT_NEAR(static_cast<double>(scenes_with(choice, [](const auto& s) { return leds_of(s).size() == 4; })),
              share(0.5), slack);
  EXPECT_NEAR(static_cast<double>(scenes_with(choice,
                                              [](const auto& s) {
                                                return std::ranges::any_of(s.scene.lights, [](const auto& light) {
                                                  return light.mirror.has_value();
                                                });
                                              })),
              share(0.15), slack);
  EXPECT_NEAR(static_cast<double>(scenes_with(choice, [](const auto& s) { return s.sensor.hot_pixel_share > 0.0; })),
              share(0.3), slack);
}

TEST(ClutterTest, RedLampsComeOnlyWhenAskedForAndChangeNothingElse) {
  ClutterChoice none;
  none.red_lamp_probability = 0.0;
  ClutterChoice always;
  always.red_lamp_probability = 1.0;
  const auto has_red_lamp = [](const SimulationSettings& settings) {
    return std::ranges::any_of(settings.scene.lights, [](const LightSource& light) {
      return light.id == 0 && is_red(light) && !light.mirror;
    });
  };
  EXPECT_EQ(scenes_with(none, has_red_lamp), 0U);
  EXPECT_EQ(scenes_with(always, has_red_lamp), kSeeds);
  const Scene with = clutter_settings(4, always).scene;
  const Scene without = clutter_settings(4, none).scene;
  ASSERT_EQ(with.surfaces.size(), without.surfaces.size());
  EXPECT_GT(with.lights.size(), without.lights.size());
  EXPECT_EQ(with.lights.front().gain, without.lights.front().gain);
  EXPECT_EQ(with.surfaces.back().outline->center_in_reference_mm,
            without.surfaces.back().outline->center_in_reference_mm);
}

TEST(ClutterTest, ChosenLevelsAreKept) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene scene = clutter_settings(seed, {.white_level = {0.01, 1.2}, .led_peak = {0.4, 100.0}}).scene;
    EXPECT_GE(scene.white_level, 0.01);
    EXPECT_LE(scene.white_level, 1.2);
    EXPECT_GE(scene.lights.front().gain.left, 2.0 * scene.white_level);  // an LED outshines a white surface
  }
}

TEST(ClutterTest, MirrorShowsTheMiddleOfTheTargetInItsMiddle) {
  int mirrors = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    ClutterStage stage{.seed = seed};
    stage.reference_from_target.translation() = Vec3(60.0, -40.0, 500.0);
    const std::optional<Outline> mirror = clutter_mirror(stage);
    if (!mirror) continue;
    ++mirrors;
    // The law of reflection: from the origin and from the target, the mirror's middle is seen at equal angles.
    const Vec3 to_origin = -mirror->center_in_reference_mm.normalized();
    const Vec3 to_target = (stage.center_mm() - mirror->center_in_reference_mm).normalized();
    EXPECT_NEAR((to_origin + to_target).normalized().dot(mirror->facing), 1.0, 1e-9) << seed;
  }
  EXPECT_GT(mirrors, 0);
}

}  // namespace
}  // namespace tripoint
