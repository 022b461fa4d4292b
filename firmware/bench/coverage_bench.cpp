// Stated against true: the share of poses whose 95 % ellipsoid holds the truth, and how far orientations are off.
//
// usage: bench_coverage [VIEWS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "bench/coverage_score.h"
#include "bench/figure.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kFirstSeed = 2'000'001;  // no test looks at them

CoverageScore scored(const CoveredTarget& target, const ErrorSources& sources, const char* of_what, int views) {
  const CoverageScore score = coverage_score(target, sources, kFirstSeed, views);
  std::fprintf(stderr,
               "coverage, %-10s, %s: %d poses of %d views, %.4f in the 95 %% ellipsoid, %.4f of axes within k = 2, "
               "%.4f mm and %.4f degrees RMS\n",
               target.name.data(), of_what, score.poses, score.views, score.inside_share, score.axes_inside_share,
               score.position_rms_mm, score.orientation_rms_deg);
  return score;
}

int run(int views) {
  std::vector<Figure> figures;
  double smallest_share = 1.0;
  for (const std::span<const CoveredTarget> targets : {covered_leds(), covered_tags()}) {
    for (const CoveredTarget& target : targets) {
      const double share = scored(target, {}, "all errors", views).inside_share;
      figures.push_back({.name = "ellipsoid_95_share_" + std::string(target.key), .value = share, .unit = "share"});
      smallest_share = std::min(smallest_share, share);
    }
  }
  figures.push_back(at_least({.name = "ellipsoid_95_share", .value = smallest_share, .unit = "share"}, 0.93));
  const CoverageScore noise =
      scored(covered_leds().back(), {.target_mm = 0.0, .calibration_px = 0.0}, "spots alone", views);
  figures.push_back(at_most({.name = "orientation_rms_deg", .value = noise.orientation_rms_deg, .unit = "deg"}, 0.05));
  print(figures);
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) {
  return tripoint::bench::run(count > 1 ? static_cast<int>(std::strtol(words[1], nullptr, 10)) : 20'000);
}
