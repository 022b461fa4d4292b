#include <array>
#include <cmath>
#include <numbers>

#include "sim/clutter_stage.h"

namespace tripoint {
namespace {

constexpr double kRoomDepth_mm = 1800.0;
constexpr double kHalfTurn_rad = std::numbers::pi;

constexpr LinearColor kPaleSkin{0.60, 0.27, 0.16};
constexpr LinearColor kDarkSkin{0.45, 0.20, 0.12};
constexpr LinearColor kOrange{0.70, 0.22, 0.02};
constexpr LinearColor kRed{0.50, 0.03, 0.03};
constexpr LinearColor kBlack{0.05, 0.05, 0.05};
constexpr LinearColor kWhite{0.80, 0.80, 0.78};
constexpr LinearColor kMetal{0.35, 0.36, 0.38};
const std::array<LinearColor, 12> kColors{kPaleSkin,
                                          kDarkSkin,
                                          kOrange,
                                          kRed,
                                          kBlack,
                                          kWhite,
                                          kMetal,
                                          LinearColor{0.75, 0.05, 0.04},   // poppy
                                          LinearColor{0.20, 0.02, 0.02},   // dark red
                                          LinearColor{0.25, 0.13, 0.06},   // wood
                                          LinearColor{0.10, 0.20, 0.50},   // blue
                                          LinearColor{0.10, 0.35, 0.12}};  // green

LinearColor dimmed(const LinearColor& color, double share) {
  return {share * color[0], share * color[1], share * color[2]};
}

/// Somewhere in both pictures, at a distance drawn evenly.
Vec3 drawn_place_mm(Draws& draws, const Range& distance_mm) {
  const double z_mm = draws.even(distance_mm);
  const double x_mm = draws.even(-0.55, 0.55) * z_mm;
  const double y_mm = draws.even(-0.42, 0.42) * z_mm;
  return {x_mm, y_mm, z_mm};
}

Surface wall_of(Draws draws, int width_px) {
  const double grey = draws.even(0.1, 0.6);
  const double warmth = draws.even(-0.1, 0.15);
  return {.reflectance = {grey * (1.0 + warmth), grey, grey * (1.0 - warmth)},
          .texture = draws.even(0.1, 0.4),
          .texture_period_px = draws.even(0.1, 0.5) * width_px};
}

void add_things(std::vector<Surface>& surfaces, Draws draws, double behind_mm) {
  constexpr int kThings = 60;
  for (int i = 0; i < kThings; ++i) {
    Surface thing;
    thing.reflectance = kColors[draws.index(kColors.size())];
    thing.reflectance = dimmed(thing.reflectance, draws.even(0.6, 1.1));
    thing.texture = draws.even(0.0, 0.3);
    thing.texture_period_mm = draws.scaled({2.0, 30.0});
    thing.shading = draws.even(0.0, 0.5);
    Outline outline{.center_in_reference_mm = drawn_place_mm(draws, {behind_mm, kRoomDepth_mm})};
    const double half_mm = draws.chance(0.55) ? draws.even(2.0, 12.0) : draws.even(20.0, 90.0);
    outline.half_axes_mm = {half_mm, half_mm * draws.even(0.3, 1.2)};
    outline.shape = draws.chance(0.5) ? Shape::kBox : Shape::kEllipse;
    outline.angle_rad = draws.even(0.0, kHalfTurn_rad);
    thing.outline = outline;
    surfaces.push_back(thing);
  }
}

/// A hand: a palm and four fingers, all of a length.
void add_hand(std::vector<Surface>& surfaces, Draws& draws, const Vec3& place_mm) {
  const double angle_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
  Surface skin{.reflectance = draws.chance(0.5) ? kPaleSkin : kDarkSkin, .texture = 0.08, .shading = 0.4};
  skin.outline = Outline{.center_in_reference_mm = place_mm, .half_axes_mm = {38.0, 44.0}, .angle_rad = angle_rad};
  surfaces.push_back(skin);
  for (int finger = 0; finger < 4; ++finger) {
    const double spread_rad = angle_rad + 0.17 * (finger - 1.5);
    const Vec3 along(std::sin(spread_rad), -std::cos(spread_rad), 0.0);
    skin.outline = Outline{.center_in_reference_mm = place_mm + 64.0 * along - 0.5 * (finger + 1.0) * Vec3::UnitZ(),
                           .half_axes_mm = {8.5, 38.0},
                           .angle_rad = spread_rad};
    surfaces.push_back(skin);
  }
}

/// A robot's arm: links from joint to joint.
void add_arm(std::vector<Surface>& surfaces, Draws draws, double behind_mm) {
  Surface paint{.reflectance = kOrange, .texture = 0.04, .shading = 0.3};
  Vec3 joint_mm = drawn_place_mm(draws, {behind_mm + 20.0, 1200.0});
  double heading_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
  for (int link = 0; link < 3; ++link) {
    const double half_length_mm = draws.even(50.0, 110.0);
    const Vec3 along(std::cos(heading_rad), std::sin(heading_rad), 0.0);
    paint.outline = Outline{.center_in_reference_mm = joint_mm + half_length_mm * along,
                            .half_axes_mm = {half_length_mm, 24.0},
                            .shape = Shape::kBox,
                            .angle_rad = heading_rad};
    surfaces.push_back(paint);
    joint_mm += 2.0 * half_length_mm * along - 2.0 * Vec3::UnitZ();
    paint.outline = Outline{.center_in_reference_mm = joint_mm, .half_axes_mm = {32.0, 32.0}};
    surfaces.push_back(paint);
    heading_rad += draws.even(-1.2, 1.2);
  }
}

void add_red_things(std::vector<Surface>& surfaces, Draws draws, double behind_mm) {
  Surface red{.reflectance = kRed, .texture = 0.1, .shading = 0.2};
  red.outline = Outline{.center_in_reference_mm = drawn_place_mm(draws, {behind_mm, 1200.0}),
                        .half_axes_mm = {60.0, 40.0},
                        .shape = Shape::kBox,
                        .angle_rad = draws.even(0.0, kHalfTurn_rad)};
  surfaces.push_back(red);
  for (int cable = 0; cable < 3; ++cable) {
    const Vec3 place_mm = drawn_place_mm(draws, {behind_mm, 1200.0});
    const double half_length_mm = draws.even(100.0, 250.0);
    const double half_width_mm = draws.even(0.6, 2.5);
    red.outline = Outline{.center_in_reference_mm = place_mm,
                          .half_axes_mm = {half_length_mm, half_width_mm},
                          .shape = Shape::kBox,
                          .angle_rad = draws.even(0.0, kHalfTurn_rad)};
    surfaces.push_back(red);
  }
}

/// What the LEDs are mounted on, in their plane and a little behind it.
Surface plate_of(Draws& draws, const Isometry3& reference_from_target) {
  const std::array<LinearColor, 5> colors{kBlack, kWhite, kRed, kOrange, kPaleSkin};
  Surface plate{.reflectance = colors[draws.index(colors.size())], .texture = 0.1, .shading = 0.3};
  const double behind_mm = draws.even(20.0, 45.0);
  const double half_width_mm = draws.even(60.0, 110.0);
  plate.outline = Outline{.center_in_reference_mm = reference_from_target * Vec3(0.0, 0.0, behind_mm),
                          .half_axes_mm = {half_width_mm, draws.even(60.0, 110.0)},
                          .shape = draws.chance(0.5) ? Shape::kBox : Shape::kEllipse,
                          .facing = reference_from_target.linear() * Vec3(0.0, 0.0, -1.0)};
  return plate;
}

}  // namespace

std::optional<Outline> clutter_mirror(const ClutterStage& stage) {
  Draws draws = stage.draws(ClutterTopic::kMirror);
  if (!draws.chance(0.15)) return std::nullopt;
  const double tilt_rad = draws.even(0.2, 0.8);
  const double turn_rad = draws.even(-kHalfTurn_rad, kHalfTurn_rad);
  const Vec3 facing(std::sin(tilt_rad) * std::cos(turn_rad), std::sin(tilt_rad) * std::sin(turn_rad),
                    -std::cos(tilt_rad));
  const double away_mm = draws.even(60.0, 130.0);
  // From the origin, where the cameras are, the middle of the target is seen at this place in it.
  const Vec3 image_mm = stage.center_mm() - 2.0 * away_mm * facing;
  const Vec3 foot_mm = stage.center_mm() - away_mm * facing;
  const Vec3 place_mm = image_mm * facing.dot(foot_mm) / facing.dot(image_mm);
  return Outline{.center_in_reference_mm = place_mm,
                 .half_axes_mm = {100.0, 80.0},
                 .shape = Shape::kBox,
                 .angle_rad = draws.even(0.0, kHalfTurn_rad),
                 .facing = facing};
}

std::vector<Surface> clutter_surfaces(const ClutterStage& stage) {
  const double behind_mm = stage.center_mm().z() + 70.0;  // no LED is behind that
  std::vector<Surface> surfaces{wall_of(stage.draws(ClutterTopic::kWall), stage.choice.size.width_px)};
  add_things(surfaces, stage.draws(ClutterTopic::kThings), behind_mm);
  add_arm(surfaces, stage.draws(ClutterTopic::kArm), behind_mm);
  add_red_things(surfaces, stage.draws(ClutterTopic::kCables), behind_mm);
  Draws plate = stage.draws(ClutterTopic::kPlate);
  if (plate.chance(0.55)) surfaces.push_back(plate_of(plate, stage.reference_from_target));
  if (const std::optional<Outline> mirror = clutter_mirror(stage)) {
    surfaces.push_back({.reflectance = kMetal, .texture = 0.2, .texture_period_mm = 60.0, .outline = mirror});
  }
  Draws hands = stage.draws(ClutterTopic::kHand);
  add_hand(surfaces, hands, drawn_place_mm(hands, {behind_mm, 1200.0}));
  if (hands.chance(0.25)) {
    const double nearness = hands.even(0.6, 0.9);
    add_hand(surfaces, hands,
             drawn_place_mm(hands, {nearness * stage.center_mm().z(), nearness * stage.center_mm().z()}));
  }
  return surfaces;
}

}  // namespace tripoint
