// A whole stereo pair of three LEDs, to be counted in instructions: `bench_pair ours|textbook`, under callgrind with
// collection switched on in `measured_pair` only (firmware/bench/instructions.py). Prints how many pairs were measured.
#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <string_view>
#include <vector>

#include "bench/textbook.h"
#include "geometry/triangulation.h"
#include "line/detect/led_detector.h"
#include "sim/default_rig.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kPairs = 32;
const std::vector<Vec3> kLeds_mm{{0.0, 0.0, 0.0}, {80.0, 25.0, 0.0}, {30.0, 60.0, 10.0}};

using YuyvPair = PerSide<std::vector<std::uint8_t>>;

SimulatedWorld three_leds_in_motion() {
  SimulationSettings settings;
  settings.scene = led_scene(kLeds_mm);
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [](double t_s) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = Vec3(-60.0 + 40.0 * t_s, -50.0 + 30.0 * t_s, 390.0 + 20.0 * t_s);
                           return pose;
                         }};
  return SimulatedWorld::create(settings).value();
}

std::vector<YuyvPair> rendered_pairs(const SimulatedWorld& world) {
  PerSide<FrameRenderer> renderers{{world, Side::kLeft}, {world, Side::kRight}};
  std::vector<YuyvPair> pairs(kPairs);
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const Duration at = std::chrono::milliseconds{31 * i};
    for (const Side side : kBothSides) {
      const Frame frame = frame_of(renderers[side].render(at, i));
      pairs[i][side].assign(frame.data.begin(), frame.data.end());
    }
  }
  return pairs;
}

class Ours {
 public:
  explicit Ours(const StereoCalibration& calibration) : rig_(rig_of(calibration).value()) {}

  /// @return how many points in space came out: of the nine pairs, those that share an epipolar plane
  std::size_t measure(const YuyvPair& pair) {
    const PerSide<Detection> seen{detected(pair, Side::kLeft), detected(pair, Side::kRight)};
    std::size_t points = 0;
    for (const ImagePoint& left : seen[Side::kLeft].points) {
      for (const ImagePoint& right : seen[Side::kRight].points) {
        const PerSide<MeasuredPixel> pixels{{left.at, left.covariance_px2}, {right.at, right.covariance_px2}};
        const auto apart = epipolar_error(rig_, pixels);
        if (!apart || apart->distance_px * apart->distance_px > kGate2 * apart->variance_px2) continue;
        points += triangulated(rig_, pixels) ? 1U : 0U;
      }
    }
    return points;
  }

 private:
  static constexpr double kGate2 = 4.5 * 4.5;

  Detection detected(const YuyvPair& pair, Side side) {
    const Picture picture = picture_of({.format = PixelFormat::kYuyv,
                                        .size = rig_.cameras[side].size,
                                        .stride_bytes = static_cast<std::size_t>(rig_.cameras[side].size.width_px) * 2,
                                        .data = pair[side]});
    return detectors_[side].detect(picture, {});
  }

  Rig rig_;
  PerSide<LedDetector> detectors_{LedDetector{LedDetectorSettings{}}, LedDetector{LedDetectorSettings{}}};
};

/// Only its detector: what it would need to triangulate is left out, in its favour.
class TextbookPair {
 public:
  std::size_t measure(const YuyvPair& pair) {
    std::size_t spots = 0;
    for (const Side side : kBothSides) spots += textbook_.spots(pair[side].data(), {640, 480}).size();
    return spots / 2;
  }

 private:
  Textbook textbook_;
};

template <typename Measurer>
[[gnu::noinline]] std::size_t measured_pair(Measurer& measurer, const YuyvPair& pair) {
  return measurer.measure(pair);
}

template <typename Measurer>
int run(Measurer measurer, const std::vector<YuyvPair>& pairs) {
  measurer.measure(pairs.front());  // memory that is taken once
  std::size_t points = 0;
  for (const YuyvPair& pair : pairs) points += measured_pair(measurer, pair);
  std::printf("%zu\n", pairs.size());
  if (points == 3 * pairs.size()) return 0;
  std::fprintf(stderr, "%zu points in %zu pairs of three LEDs\n", points, pairs.size());
  return 1;
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  using namespace tripoint::bench;
  cv::setNumThreads(1);
  const tripoint::SimulatedWorld world = three_leds_in_motion();
  const std::vector<YuyvPair> pairs = rendered_pairs(world);
  const bool textbook = argc == 2 && std::string_view(argv[1]) == "textbook";
  return textbook ? run(TextbookPair{}, pairs) : run(Ours{tripoint::default_rig()}, pairs);
}
