// What the exposure does to the place of a spot: one red LED from below clip to far above it, as a table on stderr.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "bench/figure.h"
#include "line/detect/led_detector.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr std::array kPeaks{0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0, 60.0};  // of the core, times clip
constexpr int kFrames = 30;
constexpr double kMaxMiss_px = 2.0;  // a spot further from the truth than that is another thing
constexpr double kEllipse = 5.991;   // 95 % of chi-square with two degrees of freedom

/// 16 places at 400 mm, where the peak is what it is called. Steps of 22.0 and 18.2 mm, about 34.5 and 28.6 px, put
/// each at another part of a pixel and of the mosaic.
std::vector<Vec3> places() {
  std::vector<Vec3> places_mm;
  for (int i = 0; i < 16; ++i) places_mm.emplace_back(22.0 * (i % 4 - 1.5), 18.2 * (i / 4 - 1.5), kPeakDistance_mm);
  return places_mm;
}

SimulatedWorld world_with_led(double peak, const Vec3& place_mm) {
  SimulationSettings settings;
  settings.scene = led_scene({Vec3::Zero()}, peak);
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [place_mm](double) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = place_mm;
                           return pose;
                         }};
  return SimulatedWorld::create(settings).value();
}

/// What the detector made of one peak. Squares are over both axes.
struct Seen {
  int asked = 0;
  int found = 0;
  int saturated = 0;
  int inside = 0;  ///< the ellipse of 95 % of the stated covariance
  int averages = 0;
  double single_px2 = 0.0;
  double average_px2 = 0.0;  ///< of the mean of a place's frames: what averaging does not take away
  double luma = 0.0;         ///< brightest of each spot, summed
};

/// Adds what one camera sees of a standing LED in kFrames frames.
void add(Seen& seen, LedDetector& detector, FrameRenderer&& renderer, std::uint64_t number) {
  Vec2 sum_px = Vec2::Zero();
  int found = 0;
  for (int i = 0; i < kFrames; ++i) {
    const RenderedFrame& frame = renderer.render(Duration{0}, number + static_cast<std::uint64_t>(i));
    const RawPixel truth = frame.truth.lights[0].at;
    const Detection detection = detector.detect(picture_of(frame_of(frame)), {});
    ++seen.asked;
    for (const ImagePoint& point : detection.points) {
      const Vec2 error_px(point.at.u_px - truth.u_px, point.at.v_px - truth.v_px);
      if (error_px.norm() > kMaxMiss_px) continue;
      ++found;
      sum_px += error_px;
      seen.single_px2 += error_px.squaredNorm();
      seen.luma += point.peak;
      seen.saturated += point.saturated ? 1 : 0;
      seen.inside += error_px.dot(point.covariance_px2.inverse() * error_px) < kEllipse ? 1 : 0;
      break;
    }
  }
  seen.found += found;
  if (found == 0) return;
  seen.average_px2 += (sum_px / found).squaredNorm();
  ++seen.averages;
}

Seen seen_at(double peak) {
  Seen seen;
  LedDetector detector{LedDetectorSettings{}};
  std::uint64_t number = 0;
  for (const Vec3& place_mm : places()) {
    const SimulatedWorld world = world_with_led(peak, place_mm);
    for (const Side side : kBothSides) add(seen, detector, FrameRenderer(world, side), number);
    number += kFrames;
  }
  return seen;
}

void print_row(double peak, const Seen& seen) {
  const double found = seen.found;
  std::fprintf(stderr, "%13.1f %9.1f %18.4f %15.4f %14.0f %13.1f %11.1f\n", peak, 100.0 * found / seen.asked,
               std::sqrt(seen.single_px2 / (2.0 * found)), std::sqrt(seen.average_px2 / (2.0 * seen.averages)),
               seen.luma / found, 100.0 * seen.saturated / found, 100.0 * seen.inside / found);
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  std::fprintf(stderr, "%13s %9s %18s %15s %14s %13s %11s\n", "peak, x clip", "found, %", "one frame, px RMS",
               "mean of 30, px", "brightest luma", "saturated, %", "in 95 %, %");
  for (const double peak : tripoint::bench::kPeaks) tripoint::bench::print_row(peak, tripoint::bench::seen_at(peak));
  tripoint::bench::print({});  // no figure has a goal here
}
