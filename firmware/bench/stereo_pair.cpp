#include "bench/stereo_pair.h"

#include "geometry/triangulation.h"
#include "sim/default_rig.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kPairs = 32;
constexpr double kGate2 = 4.5 * 4.5;
const std::vector<Vec3> kLeds_mm{{0.0, 0.0, 0.0}, {80.0, 25.0, 0.0}, {30.0, 60.0, 10.0}};

}  // namespace

std::vector<PairBytes> three_leds_in_motion(PixelFormat format) {
  SimulationSettings settings;
  settings.format = format;
  settings.scene = led_scene(kLeds_mm);
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [](double t_s) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = Vec3(-60.0 + 40.0 * t_s, -50.0 + 30.0 * t_s, 390.0 + 20.0 * t_s);
                           return pose;
                         }};
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  PerSide<FrameRenderer> renderers{{world, Side::kLeft}, {world, Side::kRight}};
  std::vector<PairBytes> pairs(kPairs);
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const Duration at = std::chrono::milliseconds{31 * i};
    for (const Side side : kBothSides) pairs[i][side] = renderers[side].render(at, i).pixels;
  }
  return pairs;
}

PairMeasurer::PairMeasurer() : rig_(rig_of(default_rig()).value()) {}

std::size_t PairMeasurer::measure(const PerSide<Picture>& pictures) {
  const PerSide<Detection> seen{detectors_.left.detect(pictures.left, {}), detectors_.right.detect(pictures.right, {})};
  std::size_t points = 0;
  for (const ImagePoint& left : seen.left.points) {
    for (const ImagePoint& right : seen.right.points) {
      const PerSide<MeasuredPixel> pixels{{left.at, left.covariance_px2}, {right.at, right.covariance_px2}};
      const auto apart = epipolar_error(rig_, pixels);
      if (!apart || apart->distance_px * apart->distance_px > kGate2 * apart->variance_px2) continue;
      points += triangulated(rig_, pixels) ? 1U : 0U;
    }
  }
  return points;
}

}  // namespace tripoint::bench
