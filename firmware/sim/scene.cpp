#include "sim/scene.h"

namespace tripoint {

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

}  // namespace tripoint
