#include "bench/stereo_pair.h"

#include "geometry/triangulation.h"
#include "sim/default_rig.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kPairs = 32;
constexpr double kGate2 = 4.5 * 4.5;

}  // namespace

std::vector<PairBytes> three_leds_in_motion(ImageSize size, PixelFormat format) {
  SimulationSettings settings;
  settings.rig = default_rig(size);
  settings.format = format;
  settings.scene = led_scene({kLedsOfPair_mm.begin(), kLedsOfPair_mm.end()});
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [](double t_s) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = Vec3(-60.0 + 40.0 * t_s, -50.0 + 30.0 * t_s, 390.0 + 20.0 * t_s);
                           return pose;
                         }};
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  PerSide<FrameRenderer> renderers{{world, Side::kLeft}, {world, Side::kRight}};
  std::vector<PairBytes> pairs(kPairs);
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const Duration at = i * kPairPeriod;
    for (const Side side : kBothSides) pairs[i][side] = renderers[side].render(at, i).pixels;
  }
  return pairs;
}

PairMeasurer::PairMeasurer(ImageSize size) : rig_(rig_of(default_rig(size)).value()) {}

std::size_t PairMeasurer::measure(const PerSide<Picture>& pictures) {
  seen_ = {detectors_.left.detect(pictures.left, {}), detectors_.right.detect(pictures.right, {})};
  in_rig_mm_.clear();
  for (const ImagePoint& left : seen_.left.points) {
    for (const ImagePoint& right : seen_.right.points) {
      const PerSide<MeasuredPixel> pixels{{left.at, left.covariance_px2}, {right.at, right.covariance_px2}};
      const auto apart = epipolar_error(rig_, pixels);
      if (!apart || apart->distance_px * apart->distance_px > kGate2 * apart->variance_px2) continue;
      const auto point = triangulated(rig_, pixels);
      if (point && !in_rig_mm_.full()) in_rig_mm_.push_back(point->in_rig_mm);
    }
  }
  return in_rig_mm_.size();
}

}  // namespace tripoint::bench
