#include "sim/painting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "sim/sensor.h"

namespace tripoint {
namespace {

/// A gentle pattern between -1 and 1.
double pattern(double x, double y, double period) {
  const double k = 2.0 * std::numbers::pi / period;
  return 0.5 * (std::sin(k * (x + 0.3 * y)) + std::cos(k * (0.8 * y - 0.2 * x)));
}

class Canvas {
 public:
  explicit Canvas(ImageSize size)
      : size_(size), levels_(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px)) {}

  void blend(int x, int y, double share, double level) {
    float& here =
        levels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width_px) + static_cast<std::size_t>(x)];
    here += static_cast<float>(share * (level - static_cast<double>(here)));
  }

  [[nodiscard]] ImageSize size() const { return size_; }
  [[nodiscard]] const std::vector<float>& levels() const { return levels_; }

 private:
  ImageSize size_;
  std::vector<float> levels_;
};

void paint_wall(Canvas& canvas, const Surface& wall, double white_level) {
  for (int y = 0; y < canvas.size().height_px; ++y) {
    for (int x = 0; x < canvas.size().width_px; ++x) {
      const double texture = 1.0 + wall.texture * pattern(x, y, wall.texture_period_px);
      canvas.blend(x, y, 1.0, white_level * wall.reflectance[bayer_channel(x, y)] * texture);
    }
  }
}

/// Brightness of a figure at one of its places, of 1.
double light_on(const Surface& surface, const Vec2& in_half_axes) {
  const Vec2 place_mm = in_half_axes.cwiseProduct(surface.outline->half_axes_mm);
  const double texture =
      surface.texture == 0.0 ? 0.0 : surface.texture * pattern(place_mm.x(), place_mm.y(), surface.texture_period_mm);
  return (1.0 + texture) * (1.0 - surface.shading * std::min(in_half_axes.squaredNorm(), 1.0));
}

/// The whole pixels within a reach of a centre that a picture has.
struct Extent {
  int first;
  int last;

  static Extent of(double center_px, double reach_px, int size_px) {
    return {.first = static_cast<int>(std::ceil(std::clamp(center_px - reach_px, 0.0, size_px * 1.0))),
            .last = static_cast<int>(std::floor(std::clamp(center_px + reach_px, -1.0, size_px - 1.0)))};
  }
};

void paint_figure(Canvas& canvas, const Figure& figure, double white_level, const NormalIntegral& normal) {
  const Silhouette& seen = figure.silhouette;
  const Extent across = Extent::of(seen.center.u_px, seen.reach_px.x(), canvas.size().width_px);
  const Extent down = Extent::of(seen.center.v_px, seen.reach_px.y(), canvas.size().height_px);
  for (int y = down.first; y <= down.last; ++y) {
    for (int x = across.first; x <= across.last; ++x) {
      const double share = covered_share(seen, x, y, normal);
      if (share <= 0.0) continue;
      const double light = white_level * light_on(figure.surface, place_on(seen, x, y));
      canvas.blend(x, y, share, light * figure.surface.reflectance[bayer_channel(x, y)]);
    }
  }
}

}  // namespace

std::vector<Figure> figures_of(const Scene& scene, const CameraModel& camera, const Isometry3& camera_from_reference,
                               double blur_px) {
  std::vector<Figure> figures;
  for (const Surface& surface : scene.surfaces) {
    if (!surface.outline) continue;
    const auto silhouette = silhouette_of(*surface.outline, camera, camera_from_reference, blur_px);
    if (silhouette) figures.push_back({.surface = surface, .silhouette = *silhouette});
  }
  std::ranges::stable_sort(figures, std::ranges::greater{}, [](const Figure& f) { return f.silhouette.depth_mm; });
  return figures;
}

std::vector<float> painted(const Scene& scene, const std::vector<Figure>& figures, ImageSize size,
                           const NormalIntegral& normal) {
  Canvas canvas(size);
  for (const Surface& surface : scene.surfaces) {
    if (!surface.outline) paint_wall(canvas, surface, scene.white_level);
  }
  for (const Figure& figure : figures) paint_figure(canvas, figure, scene.white_level, normal);
  return canvas.levels();
}

}  // namespace tripoint
