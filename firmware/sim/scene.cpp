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
  int id = 0;
  for (const Vec3& place_mm : places_in_target_mm) {
    scene.lights.push_back({.id = ++id, .place_mm = place_mm, .peak = peak});
  }
  return scene;
}

}  // namespace tripoint
