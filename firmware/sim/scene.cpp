#include "sim/scene.h"

#include <cmath>
#include <numbers>

namespace tripoint {

Vec3 place_mm_at(const LightSource& light, Duration since_1970) {
  if (!light.sway) return light.place_mm;
  const Sway& sway = *light.sway;
  const double turns = seconds(since_1970 % sway.period) / seconds(sway.period);
  return light.place_mm + std::sin(2.0 * std::numbers::pi * turns + sway.phase_rad) * sway.reach_mm;
}

LightSource reflection_of(const LightSource& light, const Outline& mirror, double reflectance) {
  LightSource image = light;
  image.id = 0;
  image.peak *= reflectance;
  image.mirror = mirror;
  return image;
}

Scene led_scene(const std::vector<Vec3>& places_in_target_mm, double peak) {
  Scene scene;
  for (const Vec3& place_mm : places_in_target_mm) {
    LightSource led{.id = static_cast<int>(scene.lights.size()) + 1, .place_mm = place_mm, .peak = peak};
    led.switched_by = scene.lights.size();
    scene.lights.push_back(led);
  }
  return scene;
}

LightSource fixed_lamp(const Scene& scene, const Vec3& place_in_reference_mm) {
  LightSource lamp = scene.lights.empty() ? LightSource{} : scene.lights.front();
  lamp.id = 0;
  lamp.mount = Mount::kReference;
  lamp.place_mm = place_in_reference_mm;
  lamp.switched_by.reset();
  return lamp;
}

}  // namespace tripoint
