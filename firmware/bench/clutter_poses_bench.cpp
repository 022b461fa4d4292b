// What a whole unit says about the pose of a target among clutter: held-back scenes, from pictures to verdicts.
//
// usage: bench_clutter_poses [SCENES [FIRST_SEED]]
// Names each wrong pose on stderr; its figures on stdout.
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "bench/clutter_scoring.h"
#include "bench/figure.h"
#include "bench/pose_error.h"
#include "bench/stepped_unit.h"
#include "sim/clutter.h"

namespace tripoint::bench {
namespace {

constexpr int kThreads = 2;
constexpr std::uint64_t kHeldBack = 300'001;  ///< nothing was fitted to the scenes from here on
constexpr int kFramesToFind = 3;
constexpr Duration kLooked = std::chrono::milliseconds(300);  // nine pictures of each camera, the first ones included

struct Tally {
  int scenes = 0;
  int scenes_with_pose = 0;
  int verdicts = 0;
  int poses = 0;
  int wrong = 0;
  int beyond = 0;        ///< further from the truth than true normal errors are in 999 of 1,000 poses
  int asked = 0;         ///< LEDs to be found in the first three pictures of a camera
  int found = 0;         ///< in one of them at least
  int missed_alone = 0;  ///< of those that were never found: no other light was near

  void add(const Tally& other) {
    scenes += other.scenes;
    scenes_with_pose += other.scenes_with_pose;
    verdicts += other.verdicts;
    poses += other.poses;
    wrong += other.wrong;
    beyond += other.beyond;
    asked += other.asked;
    found += other.found;
    missed_alone += other.missed_alone;
  }
};

/// What the first pictures of a camera have shown of an LED.
struct Sight {
  int asked = 0;
  int alone = 0;
  int found = 0;
};
struct Seen {
  int pictures = 0;
  std::map<int, Sight> leds;  ///< by id
};

SimulationSettings settings_of(std::uint64_t seed) {
  SimulationSettings settings = clutter_settings(seed, {.min_leds = 3});
  settings.clocks.right.phase = std::chrono::milliseconds(7);
  return settings;
}

void look(Seen& seen, const Observation& observation, const FrameTruth& truth, const SimulatedWorld& world) {
  if (seen.pictures++ >= kFramesToFind) return;
  Detection detection;
  detection.points = observation.points;
  for (const LedScore& led : view_score(detection, {}, truth, world).leds) {
    Sight& sight = seen.leds[led.id];
    ++sight.asked;
    sight.alone += led.company == Company::kAlone ? 1 : 0;
    sight.found += led.found ? 1 : 0;
  }
}

/// LEDs that were to be found in each of the first pictures; a moving highlight may outshine one in some of them.
void count(Tally& tally, const Seen& seen) {
  for (const auto& [id, sight] : seen.leds) {
    if (sight.asked < kFramesToFind) continue;
    ++tally.asked;
    tally.found += sight.found > 0 ? 1 : 0;
    tally.missed_alone += sight.found == 0 && sight.alone == kFramesToFind ? 1 : 0;
  }
}

void judge(Tally& tally, const Measurement& verdict, const SimulationSettings& settings) {
  ++tally.verdicts;
  if (!verdict.pose) return;
  ++tally.poses;
  const PoseError error =
      pose_error(*verdict.pose, target_pose_at(settings.trajectory, verdict.exposed.time_since_epoch()));
  tally.beyond += tail_beyond(error) < 1e-3 ? 1 : 0;
  if (!is_wrong(error)) return;
  ++tally.wrong;
  std::fprintf(stderr, "wrong: seed %llu, %.2f mm, %.2f degrees, chi-square %.1f\n",
               static_cast<unsigned long long>(settings.seed), error.position_mm(),
               error.angle_rad() * 180.0 / std::numbers::pi, error.chi2);
}

Tally tally_of_scene(std::uint64_t seed) {
  Tally tally{.scenes = 1};
  const SimulationSettings settings = settings_of(seed);
  PerSide<Seen> seen;
  SteppedUnit unit(settings, clutter_model(settings), std::nullopt,
                   {[&](const Observation& observation, const FrameTruth& truth, const SimulatedWorld& world) {
                      look(seen[observation.side], observation, truth, world);
                    },
                    [&](const Measurement& verdict) { judge(tally, verdict, settings); }});
  unit.run_for(kLooked);
  for (const Side side : kBothSides) count(tally, seen[side]);
  tally.scenes_with_pose = tally.poses > 0 ? 1 : 0;
  return tally;
}

Tally tally_of(std::uint64_t scenes, std::uint64_t first_seed) {
  std::vector<Tally> tallies(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t thread = 0; thread < kThreads; ++thread) {
      threads.emplace_back([&tallies, thread, scenes, first_seed] {
        for (std::uint64_t i = thread; i < scenes; i += kThreads) tallies[thread].add(tally_of_scene(first_seed + i));
      });
    }
  }
  Tally sum;
  for (const Tally& tally : tallies) sum.add(tally);
  return sum;
}

int run(std::uint64_t scenes, std::uint64_t first_seed) {
  const Tally tally = tally_of(scenes, first_seed);
  const auto share = [](int part, int whole) { return part / std::max(1.0, whole * 1.0); };
  std::fprintf(stderr,
               "poses in clutter: %d scenes, %d of them with a pose; %d verdicts, %d poses, %d of them wrong, %.5f "
               "beyond 99.9 %%; "
               "%d of %d LEDs found within three pictures; %d of the others stand alone\n",
               tally.scenes, tally.scenes_with_pose, tally.verdicts, tally.poses, tally.wrong,
               share(tally.beyond, tally.poses), tally.found, tally.asked, tally.missed_alone);
  print({at_most({.name = "clutter_wrong_poses", .value = 1.0 * tally.wrong, .unit = "poses"}, 0.0),
         {.name = "clutter_pose_share", .value = share(tally.poses, tally.verdicts), .unit = "share"},
         {.name = "clutter_leds_found_in_three_share", .value = share(tally.found, tally.asked), .unit = "share"}});
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) {
  return tripoint::bench::run(count > 1 ? std::stoull(words[1]) : 3000,
                              count > 2 ? std::stoull(words[2]) : tripoint::bench::kHeldBack);
}
