#include "sim/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
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

/// What a scene may hold, and in what share of the scenes it does.
struct Kind {
  std::string_view name;
  double share;
  bool (*is_in)(const SimulationSettings& settings);
};

template <typename Is>
bool any_light(const SimulationSettings& settings, const Is& is) {
  return std::ranges::any_of(settings.scene.lights, is);
}

template <typename Is>
std::ptrdiff_t figures(const SimulationSettings& settings, const Is& is) {
  return std::ranges::count_if(settings.scene.surfaces,
                               [&](const Surface& surface) { return surface.outline && is(surface); });
}

bool is_standing(const LightSource& light) {
  return light.id == 0 && light.mount == Mount::kReference && !light.mirror && light.veil_share == 0.0;
}

/// A palm is 38 by 44 mm, and no other figure is.
bool is_palm(const Surface& surface) { return surface.outline->half_axes_mm == Vec2(38.0, 44.0); }

/// A robot's arm has three joints of 32 mm.
bool is_joint(const Surface& surface) { return surface.outline->half_axes_mm == Vec2(32.0, 32.0); }

/// Cables are boxes of 0.6 to 2.5 mm by 100 to 250 mm.
bool is_cable(const Surface& surface) {
  return surface.outline->half_axes_mm.x() >= 100.0 && surface.outline->half_axes_mm.y() <= 2.5;
}

const std::array kKinds{
    Kind{"four LEDs", 0.5, [](const auto& s) { return leds_of(s).size() == 4; }},
    Kind{"a mirror", 0.15,
         [](const auto& s) { return any_light(s, [](const auto& l) { return l.mirror.has_value(); }); }},
    Kind{"hot pixels", 0.3, [](const auto& s) { return s.sensor.hot_pixel_share > 0.0; }},
    Kind{"glare", 0.12, [](const auto& s) { return any_light(s, [](const auto& l) { return l.veil_share == 1.0; }); }},
    Kind{"a wide lamp", 0.5,
         [](const auto& s) { return any_light(s, [](const auto& l) { return l.veil_share == 0.05; }); }},
    Kind{"two white LEDs", 1.0,
         [](const auto& s) {
           return std::ranges::count_if(s.scene.lights, [](const auto& l) {
                    return is_standing(l) && l.color[1] > l.color[0] && l.color[1] > l.color[2];
                  }) >= 2;
         }},
    // 8 to 30, four of five of them with more red than green.
    Kind{"highlights", 1.0,
         [](const auto& s) {
           return std::ranges::count_if(s.scene.lights, [](const auto& l) {
                    return is_standing(l) && l.color[0] >= l.color[1] && !is_red(l);
                  }) >= 2;
         }},
    // Every fourth of 8 to 30: none of them in 0.019 of the scenes.
    Kind{"highlights that move by themselves", 0.98,
         [](const auto& s) { return any_light(s, [](const auto& l) { return l.sway.has_value(); }); }},
    // On the body in 0.3 of the scenes, beside an LED in 0.15: 1 - 0.7 x 0.85.
    Kind{"highlights that move with the target", 0.405,
         [](const auto& s) {
           return any_light(s, [](const auto& l) { return l.id == 0 && l.mount == Mount::kTarget && !l.mirror; });
         }},
    Kind{"an arm", 1.0, [](const auto& s) { return figures(s, is_joint) == 3; }},
    Kind{"three cables", 1.0, [](const auto& s) { return figures(s, is_cable) == 3; }},
    Kind{"a hand", 1.0, [](const auto& s) { return figures(s, is_palm) >= 1; }},
    Kind{"a hand in front", 0.25, [](const auto& s) { return figures(s, is_palm) == 2; }},
    Kind{"a plate of the LEDs", 0.55,
         [](const auto& s) {
           return figures(s, [](const auto& f) { return f.shading == 0.3 && f.texture == 0.1; }) == 1;
         }},
};

TEST(ClutterTest, ScenesVaryAsTheDocumentSays) {
  for (const Kind& kind : kKinds) {
    const double scenes = static_cast<double>(kSeeds);
    const double expected = kind.share * scenes;
    const double slack = 4.0 * std::sqrt(scenes * kind.share * (1.0 - kind.share));  // standard deviations
    const auto seen = static_cast<double>(scenes_with(ClutterChoice{}, kind.is_in));
    EXPECT_GT(seen, 0.0) << kind.name;
    EXPECT_NEAR(seen, expected, slack) << kind.name;
  }
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
