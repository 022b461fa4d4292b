// What the parts of a cluttered scene must know of each other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/clutter.h"
#include "sim/scene.h"
#include "sim/sensor.h"
#include "values/linear.h"

namespace tripoint {

/// Each part draws for itself.
enum class ClutterTopic : std::uint8_t {
  kSensor,
  kTarget,
  kWall,
  kThings,
  kArm,
  kCables,
  kHand,
  kPlate,
  kMirror,
  kLeds,
  kHighlights,
  kLamps,
  kRedLamps,
  kNearHighlight,
  kReflections,
  kGlare,
  kSway,
};

struct ClutterStage {
  std::uint64_t seed = 0;
  ClutterChoice choice{};
  double white_level = 0.05;
  double focal_px = 628.0;
  SensorModel sensor{};
  Isometry3 reference_from_target = Isometry3::Identity();
  std::vector<Vec3> leds_in_target_mm{};

  [[nodiscard]] Draws draws(ClutterTopic topic) const { return {seed, static_cast<std::uint64_t>(topic)}; }
  /// Middle of the target, in the reference frame.
  [[nodiscard]] Vec3 center_mm() const { return reference_from_target.translation(); }
};

/// The wall, and the things before it.
std::vector<Surface> clutter_surfaces(const ClutterStage& stage);

/// A mirror that shows the target to both cameras, in some scenes.
std::optional<Outline> clutter_mirror(const ClutterStage& stage);

/// The LEDs, and every light that is none. Highlights sit on the surfaces.
std::vector<LightSource> clutter_lights(const ClutterStage& stage, const std::vector<Surface>& surfaces);

}  // namespace tripoint
