// A camera knocked by a tenth of a degree about each axis, and a day without a knock; with seeds that no test looks at.
//
// usage: bench_bump [KNOCKS [HOURS]]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <string>
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

/// Fixed to the machine, below the working volume and to its left.
const Vec3 kDatum_mm{-120.0, 110.0, 620.0};

struct Trial {
  std::string name;
  Watched watched;
  bool both_cameras = false;  ///< else one of them, in turn
};

std::vector<double> sorted_times_s(const Trial& trial, const Axis& axis, int knocks) {
  std::vector<double> times_s;
  for (int i = 0; i < knocks; ++i) {
    Bump bump{.side = kBothSides[static_cast<std::size_t>(i) % 2]};
    if (trial.both_cameras) bump.side.reset();
    bump.turn_rad = (i % 4 < 2 ? kTurn_rad : -kTurn_rad) * axis.of_camera;
    const auto seed = kFirstSeed + 1000 * static_cast<std::uint64_t>(i);
    times_s.push_back(seconds_to_alarm(trial.watched, {}, bump, seed, kLimit_s));
  }
  std::sort(times_s.begin(), times_s.end());
  return times_s;
}

/// Seconds in 95 of 100 knocks.
double tell_times_s(const Trial& trial, const Axis& axis, int knocks) {
  const std::vector<double> times_s = sorted_times_s(trial, axis, knocks);
  const auto at = [&](double share) { return times_s[static_cast<std::size_t>(share * (knocks - 1))]; };
  std::fprintf(stderr, "bump, %-24s %-5s: %.2f s median, %.2f in 95 of 100, %.2f at most, of %d\n", trial.name.c_str(),
               axis.name.c_str(), at(0.5), at(0.95), at(1.0), knocks);
  return at(0.95);
}

int tell_false_alarms(const Trial& trial, double hours) {
  const unsigned workers = std::max(1U, std::thread::hardware_concurrency());
  std::vector<int> alarms(workers, 0);
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < workers; ++k) {
      threads.emplace_back([&, k] {
        alarms[k] =
            alarms_without_cause(trial.watched, {}, kFirstSeed + 1'000'000'000ULL * (k + 1), 3600.0 * hours / workers);
      });
    }
  }
  const int sum = std::accumulate(alarms.begin(), alarms.end(), 0);
  std::fprintf(stderr, "bump, %s, no knock: %d alarms in %.1f hours\n", trial.name.c_str(), sum, hours);
  return sum;
}

int run(int knocks, double hours) {
  std::vector<Figure> figures;
  for (const CoveredTarget& target : covered_leds()) {
    if (target.leds_mm.size() < 3) continue;
    for (const Axis& axis : kAxes) {
      const double time_s = tell_times_s({std::string(target.name), {target.leds_mm}}, axis, knocks);
      if (target.leds_mm.size() == 3) {
        figures.push_back(at_most({.name = "bump_" + axis.name + "_s", .value = time_s, .unit = "s"}, 1.0));
      }
    }
  }
  const std::span<const Vec3> three = covered_leds()[1].leds_mm;
  const std::array<Trial, 2> with_datum{
      {{"one LED, datum", {three.first(1), kDatum_mm}}, {"three LEDs, datum", {three, kDatum_mm}}}};
  for (Trial trial : with_datum) {
    for (const Axis& axis : kAxes) tell_times_s(trial, axis, knocks);
    trial.name += ", both";
    trial.both_cameras = true;
    for (const Axis& axis : kAxes) tell_times_s(trial, axis, knocks);
  }
  const int alarms = tell_false_alarms({"three LEDs", {three}}, hours);
  for (const Trial& trial : with_datum) tell_false_alarms(trial, hours);
  figures.push_back(at_most({.name = "bump_false_alarms", .value = 1.0 * alarms, .unit = "alarms"}, 0.0));
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
