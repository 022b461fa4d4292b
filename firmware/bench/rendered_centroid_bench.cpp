// How well single spots of rendered pictures are measured, against what the luma of YUYV lets anyone know, and against
// what is stated. A table on stderr, one row for each kind of picture; figures of YUYV and good MJPEG on stdout.
#include <cstdio>
#include <string>
#include <vector>

#include "bench/figure.h"
#include "bench/luma_bound.h"
#include "bench/rendered_spots.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr int kPictures = 80;  // of 24 spots: chance moves an RMS by 1.1 %
constexpr std::uint64_t kSeed = 1;

/// As in a short exposure of a weak light: noise is what errs. The bound is then near 0.05 px, as in the static
/// figures.
constexpr SensorModel kNoisy{.read_noise = 0.0093, .full_well_electrons = 430.0};
/// The default sensor: what is left is how mosaic, chroma and compression bend the spot.
constexpr SensorModel kQuiet{};

struct Packing {
  std::string name;
  std::string figure;  ///< what its figures are called after; empty: none
  PixelFormat format;
  ChromaSampling sampling;
  int quality;
};

std::vector<Packing> packings() {
  return {{"yuyv", "rendered", PixelFormat::kYuyv, ChromaSampling::k422, 90},
          {"mjpeg_422_q90", "rendered_mjpeg", PixelFormat::kMjpeg, ChromaSampling::k422, 90},
          {"mjpeg_422_q70", "", PixelFormat::kMjpeg, ChromaSampling::k422, 70},
          {"mjpeg_420_q90", "", PixelFormat::kMjpeg, ChromaSampling::k420, 90},
          {"mjpeg_420_q50", "", PixelFormat::kMjpeg, ChromaSampling::k420, 50}};
}

/// Of the LED in the middle: to both sides the peak changes evenly with the distance, which the mean does not show.
double bound_px(const SpotPictures& pictures) {
  const SimulationSettings settings = one_spot(pictures);
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  const LightTruth spot = render(world, Side::kLeft, Duration{0}).truth.lights[0];
  return luma_bound_px(settings.sensor, spot, settings.scene.lights[0], wall_level(settings.scene));
}

SpotErrors measured_row(const std::string& name, const SpotPictures& pictures, double bound) {
  const SpotErrors errors = spot_errors(pictures, kPictures, kSeed);
  std::fprintf(stderr, "%-24s %6d %7zu %8.4f %8.4f %8.2f %12.3f %11.1f\n", name.c_str(), errors.asked,
               errors.found.size(), errors.rms_px(), bound, errors.rms_px() / bound, errors.rms_over_stated(),
               100.0 * errors.share_in_95());
  return errors;
}

std::vector<Figure> figures_of(const std::string& suffix, const SpotErrors& errors, double bound) {
  const double ratio = errors.rms_px() / bound;
  return {
      {.name = "centroid_rms_vs_bound_" + suffix, .value = ratio, .unit = "ratio", .baseline = bound, .ratio = ratio},
      {.name = "centroid_rms_vs_stated_" + suffix, .value = errors.rms_over_stated(), .unit = "ratio"}};
}

void add_rows(std::vector<Figure>& figures, const std::string& suffix, const SensorModel& sensor) {
  const double bound = bound_px({.sensor = sensor});
  for (const Packing& packing : packings()) {
    const SpotPictures pictures{
        .format = packing.format, .sampling = packing.sampling, .quality = packing.quality, .sensor = sensor};
    const SpotErrors errors = measured_row(packing.name + suffix, pictures, bound);
    if (packing.figure.empty()) continue;
    const std::vector<Figure> more = figures_of(packing.figure + suffix, errors, bound);
    figures.insert(figures.end(), more.begin(), more.end());
  }
}

}  // namespace
}  // namespace tripoint::bench

int main() {
  using namespace tripoint::bench;
  std::fprintf(stderr, "%-24s %6s %7s %8s %8s %8s %12s %11s\n", "", "spots", "found", "RMS px", "bound px", "ratio",
               "over stated", "in 95 %, %");
  std::vector<Figure> figures;
  add_rows(figures, "", kNoisy);
  add_rows(figures, "_low_noise", kQuiet);
  print(figures);
  return 0;
}
