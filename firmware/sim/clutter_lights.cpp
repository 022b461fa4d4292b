#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/clutter_stage.h"

namespace tripoint {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;
constexpr LinearColor kWarmWhite{1.0, 0.80, 0.55};
constexpr LinearColor kWhiteLed{0.80, 1.0, 0.90};
const std::array<LinearColor, 5> kHighlightColors{LinearColor{1.0, 1.0, 1.0}, LinearColor{1.0, 0.75, 0.45},
                                                  LinearColor{0.8, 0.9, 1.0}, LinearColor{1.0, 0.55, 0.2},
                                                  LinearColor{1.0, 0.85, 0.6}};

/// What all LEDs of a target have in common, and the lens's halo, which all lights share.
struct LedMake {
  double core_sigma_mm;
  double halo_share;
  double elongation;
  LinearColor color;
};

LedMake drawn_make(Draws& draws) {
  return {.core_sigma_mm = draws.even(0.8, 1.5),
          .halo_share = draws.even(0.003, 0.03),
          .elongation = draws.even(1.0, 1.25),
          .color = {1.0, draws.even(0.03, 0.10), draws.even(0.015, 0.05)}};
}

/// The `peak` of a light whose core is to have a peak of 1 in the picture at this distance.
double peak_for_one(const ClutterStage& stage, double core_sigma_mm, double distance_mm) {
  const auto area = [&](double at_mm) {
    return std::pow(stage.sensor.optical_sigma_px, 2) + std::pow(core_sigma_mm * stage.focal_px / at_mm, 2);
  };
  return area(distance_mm) / area(kPeakDistance_mm) * std::pow(distance_mm / kPeakDistance_mm, 2);
}

/// A light that stands still, of this peak in the picture; highlights and lamps differ much between the two views.
LightSource standing(const ClutterStage& stage, Draws& draws, const Vec3& place_mm, double core_sigma_mm,
                     double peak_in_picture) {
  LightSource light{.id = 0, .mount = Mount::kReference, .place_mm = place_mm, .core_sigma_mm = core_sigma_mm};
  light.peak = peak_in_picture * peak_for_one(stage, core_sigma_mm, place_mm.z());
  for (const Side side : kBothSides) light.gain[side] = std::exp(0.4 * draws.normal());
  light.elongation = draws.even(1.0, 1.6);
  light.elongation_angle_rad = draws.even(0.0, kHalfTurn_rad);
  return light;
}

Vec3 drawn_place_mm(Draws& draws, const Range& distance_mm) {
  const double z_mm = draws.even(distance_mm);
  const double x_mm = draws.even(-0.5, 0.5) * z_mm;
  const double y_mm = draws.even(-0.38, 0.38) * z_mm;
  return {x_mm, y_mm, z_mm};
}

/// The LEDs; each has its own brightness and direction, but is within the range that was chosen in both views.
std::vector<LightSource> leds(const ClutterStage& stage) {
  Draws draws = stage.draws(ClutterTopic::kLeds);
  const LedMake make = drawn_make(draws);
  const Range range{std::max(stage.choice.led_peak.low, 2.0 * stage.white_level),
                    std::max(stage.choice.led_peak.high, 2.0 * stage.white_level)};
  const double all_peak = draws.scaled(range);
  std::vector<LightSource> lights;
  for (const Vec3& place_mm : stage.leds_in_target_mm) {
    LightSource led{.id = static_cast<int>(lights.size()) + 1, .place_mm = place_mm, .color = make.color};
    led.switched_by = lights.size();
    led.facing = -Vec3::UnitZ();
    led.core_sigma_mm = make.core_sigma_mm;
    led.halo_share = make.halo_share;
    led.elongation = make.elongation;
    led.elongation_angle_rad = draws.even(0.0, kHalfTurn_rad);
    led.peak = peak_for_one(stage, make.core_sigma_mm, (stage.reference_from_target * place_mm).z());
    const double own_peak = all_peak * std::exp(0.2 * draws.normal());
    for (const Side side : kBothSides) {
      led.gain[side] = std::clamp(own_peak * std::exp(0.2 * draws.normal()), range.low, range.high);
    }
    lights.push_back(led);
  }
  return lights;
}

/// Every fourth highlight or so wanders over its figure, as over metal that turns or water that moves.
void let_sway(std::vector<LightSource>& lights, const ClutterStage& stage) {
  Draws draws = stage.draws(ClutterTopic::kSway);
  for (LightSource& light : lights) {
    const bool sways = draws.chance(0.25);
    const double angle_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
    const double reach_mm = draws.scaled({3.0, 30.0});
    const double period_s = draws.scaled({0.3, 3.0});
    const double phase_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
    if (!sways) continue;
    const Vec3 along(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    light.sway = Sway{reach_mm * along, duration_from_seconds(period_s), phase_rad};
  }
}

/// On the figures, a little before them: nearly white, whatever the figure's colour.
void add_highlights(std::vector<LightSource>& lights, const ClutterStage& stage, const std::vector<Surface>& surfaces) {
  Draws draws = stage.draws(ClutterTopic::kHighlights);
  std::vector<LightSource> highlights;
  const std::size_t count = 8 + draws.index(23);
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Outline>& figure = surfaces[1 + draws.index(surfaces.size() - 1)].outline;
    const Vec2 offset_mm = figure->half_axes_mm.minCoeff() * Vec2{draws.even(-0.7, 0.7), draws.even(-0.7, 0.7)};
    const Vec3 place_mm = figure->center_in_reference_mm + Vec3(offset_mm.x(), offset_mm.y(), -2.0);
    const double sigma_mm = draws.scaled({0.3, 4.0});
    const double peak = stage.white_level * draws.scaled({1.0, 60.0});
    LightSource highlight = standing(stage, draws, place_mm, sigma_mm, peak);
    highlight.color = kHighlightColors[draws.index(kHighlightColors.size())];
    highlights.push_back(highlight);
  }
  let_sway(highlights, stage);
  lights.insert(lights.end(), highlights.begin(), highlights.end());
}

/// A wide warm lamp in half of the scenes, and two white LEDs.
void add_lamps(std::vector<LightSource>& lights, const ClutterStage& stage, double led_sigma_mm) {
  Draws draws = stage.draws(ClutterTopic::kLamps);
  if (draws.chance(0.5)) {
    const Vec3 place_mm = drawn_place_mm(draws, {stage.center_mm().z() + 100.0, 1600.0});
    const double sigma_mm = draws.even(10.0, 30.0);
    const double peak = stage.white_level * draws.scaled({20.0, 200.0});
    LightSource lamp = standing(stage, draws, place_mm, sigma_mm, peak);
    lamp.color = kWarmWhite;
    lamp.veil_share = 0.05;
    lights.push_back(lamp);
  }
  for (int i = 0; i < 2; ++i) {
    const Vec3 place_mm = drawn_place_mm(draws, {stage.center_mm().z(), 1600.0});
    const double led_peak = draws.scaled(stage.choice.led_peak);
    const double peak = led_peak * draws.scaled({0.3, 3.0});
    LightSource white = standing(stage, draws, place_mm, led_sigma_mm, peak);
    white.color = kWhiteLed;
    lights.push_back(white);
  }
}

/// One or two, like the LEDs in size, colour and brightness.
void add_red_lamps(std::vector<LightSource>& lights, const ClutterStage& stage, const LightSource& led) {
  Draws draws = stage.draws(ClutterTopic::kRedLamps);
  if (!draws.chance(stage.choice.red_lamp_probability)) return;
  const std::size_t count = 1 + draws.index(2);
  for (std::size_t i = 0; i < count; ++i) {
    const double z_mm = stage.center_mm().z();
    const Vec3 place_mm = drawn_place_mm(draws, {0.8 * z_mm, 1.5 * z_mm});
    const double sigma_mm = led.core_sigma_mm * draws.scaled({0.6, 1.6});
    const double led_peak = draws.scaled(stage.choice.led_peak);
    const double peak = led_peak * draws.scaled({0.4, 2.5});
    LightSource lamp = standing(stage, draws, place_mm, sigma_mm, peak);
    lamp.color = led.color;
    lights.push_back(lamp);
  }
}

/// Highlights that move with the target: one on its body, and sometimes one right beside an LED.
void add_near_highlights(std::vector<LightSource>& lights, const ClutterStage& stage, const LightSource& led) {
  Draws draws = stage.draws(ClutterTopic::kNearHighlight);
  const double distance_mm = stage.center_mm().z();
  const auto add = [&](const Vec3& in_target_mm, double peak) {
    LightSource highlight = standing(stage, draws, Vec3(0.0, 0.0, distance_mm), 0.7 * led.core_sigma_mm, peak);
    highlight.mount = Mount::kTarget;
    highlight.place_mm = in_target_mm;
    highlight.color = {1.0, 0.95, 0.9};
    lights.push_back(highlight);
  };
  const bool on_body = draws.chance(0.3);
  const Vec3 on_body_mm{draws.even(-45.0, 45.0), draws.even(-45.0, 45.0), 5.0};
  if (on_body) add(on_body_mm, stage.white_level * draws.scaled({2.0, 30.0}));
  if (!draws.chance(0.15)) return;
  const double px_per_mm = stage.focal_px / distance_mm;
  const double spot_sigma_mm = std::hypot(stage.sensor.optical_sigma_px / px_per_mm, led.core_sigma_mm);
  const double apart_mm = draws.even(3.0, 7.0) * spot_sigma_mm;
  const double angle_rad = draws.even(0.0, 2.0 * kHalfTurn_rad);
  const Vec3& beside_mm = stage.leds_in_target_mm[draws.index(stage.leds_in_target_mm.size())];
  add(beside_mm + Vec3(apart_mm * std::cos(angle_rad), apart_mm * std::sin(angle_rad), 3.0),
      stage.white_level * draws.scaled({2.0, 30.0}));
}

void add_reflections(std::vector<LightSource>& lights, const ClutterStage& stage) {
  const std::optional<Outline> mirror = clutter_mirror(stage);
  if (!mirror) return;
  Draws draws = stage.draws(ClutterTopic::kReflections);
  const std::vector<LightSource> before = lights;
  for (const LightSource& light : before) {
    if (light.id != 0) lights.push_back(reflection_of(light, *mirror, draws.even(0.1, 0.6)));
  }
}

/// The sun, or a window: small, a hundred times as bright as white, mostly beside the picture; its veil reaches in.
void add_glare(std::vector<LightSource>& lights, const ClutterStage& stage) {
  Draws draws = stage.draws(ClutterTopic::kGlare);
  if (!draws.chance(0.12)) return;
  const double angle_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
  const double aside = draws.even(0.4, 0.7);
  const Vec3 place_mm = 2000.0 * Vec3(aside * std::cos(angle_rad), 0.8 * aside * std::sin(angle_rad), 1.0);
  LightSource glare = standing(stage, draws, place_mm, 25.0, stage.white_level * draws.scaled({100.0, 600.0}));
  glare.color = kWarmWhite;
  glare.veil_share = 1.0;
  glare.veil_of_width = draws.even(0.06, 0.15);
  lights.push_back(glare);
}

}  // namespace

std::vector<LightSource> clutter_lights(const ClutterStage& stage, const std::vector<Surface>& surfaces) {
  std::vector<LightSource> lights = leds(stage);
  const LightSource led = lights.front();
  add_reflections(lights, stage);
  add_highlights(lights, stage, surfaces);
  add_lamps(lights, stage, led.core_sigma_mm);
  add_red_lamps(lights, stage, led);
  add_near_highlights(lights, stage, led);
  add_glare(lights, stage);
  for (LightSource& light : lights) light.halo_share = led.halo_share;
  return lights;
}

}  // namespace tripoint
