// A camera knocked by a tenth of a degree about each axis, and a day without a knock; with seeds that no test looks at.
//
// usage: bench_bump [KNOCKS [HOURS]]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <thread>
#include <vector>

#include "bench/bump_score.h"
#include "bench/coverage_score.h"
#include "bench/figure.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kFirstSeed = 1'000'001;
constexpr double kTurn_rad = 0.1 * std::numbers::pi / 180.0;
constexpr double kLimit_s = 60.0;

struct Axis {
  std::string name;
  Vec3 of_camera;
};
const std::array<Axis, 3> kAxes{{{"pitch", Vec3::UnitX()}, {"yaw", Vec3::UnitY()}, {"roll", Vec3::UnitZ()}}};

std::vector<double> sorted_times_s(std::span<const Vec3> leds_mm, const Axis& axis, int knocks) {
  std::vector<double> times_s;
  for (int i = 0; i < knocks; ++i) {
    const Side side = kBothSides[static_cast<std::size_t>(i) % 2];
    const double turn_rad = i % 4 < 2 ? kTurn_rad : -kTurn_rad;
    const auto seed = kFirstSeed + 1000 * static_cast<std::uint64_t>(i);
    times_s.push_back(seconds_to_alarm(leds_mm, {}, {side, turn_rad * axis.of_camera}, seed, kLimit_s));
  }
  std::sort(times_s.begin(), times_s.end());
  return times_s;
}

int run(int knocks, double hours) {
  std::vector<Figure> figures;
  for (const CoveredTarget& target : covered_leds()) {
    if (target.leds_mm.size() < 3) continue;
    for (const Axis& axis : kAxes) {
      const std::vector<double> times_s = sorted_times_s(target.leds_mm, axis, knocks);
      const auto at = [&](double share) { return times_s[static_cast<std::size_t>(share * (knocks - 1))]; };
      std::fprintf(stderr, "bump, %-10s %-5s: %.2f s median, %.2f in 95 of 100, %.2f at most, of %d\n",
                   target.name.data(), axis.name.c_str(), at(0.5), at(0.95), at(1.0), knocks);
      if (target.leds_mm.size() == 3) {
        figures.push_back(at_most({.name = "bump_" + axis.name + "_s", .value = at(0.95), .unit = "s"}, 1.0));
      }
    }
  }
  const std::span<const Vec3> three = covered_leds()[1].leds_mm;
  const unsigned workers = std::max(1U, std::thread::hardware_concurrency());
  std::vector<int> alarms(workers, 0);
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < workers; ++k) {
      threads.emplace_back([&, k] {
        alarms[k] = alarms_without_cause(three, {}, kFirstSeed + 1'000'000'000ULL * (k + 1), 3600.0 * hours / workers);
      });
    }
  }
  int sum = 0;
  for (const int count : alarms) sum += count;
  std::fprintf(stderr, "bump, no knock: %d alarms in %.1f hours\n", sum, hours);
  figures.push_back(at_most({.name = "bump_false_alarms", .value = 1.0 * sum, .unit = "alarms"}, 0.0));
  print(figures);
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) {
  const int knocks = count > 1 ? static_cast<int>(std::strtol(words[1], nullptr, 10)) : 200;
  const double hours = count > 2 ? std::strtod(words[2], nullptr) : 24.0;
  return tripoint::bench::run(knocks, hours);
}
