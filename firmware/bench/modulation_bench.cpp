// What modulation is worth: LEDs found, other spots believed and poses wrong with it and without it, where red lamps
// are.
//
// usage: bench_modulation [SCENES [FIRST_SEED]]
// A table on stderr, one row for each kind of scene; its figures on stdout.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/clutter_scoring.h"
#include "bench/figure.h"
#include "bench/pose_error.h"
#include "bench/stepped_unit.h"
#include "sim/clutter.h"
#include "sim/world.h"

namespace tripoint::bench {
namespace {

constexpr Duration kProving = std::chrono::milliseconds(600);  // longer than it takes until an LED is believed
constexpr Duration kScored = std::chrono::milliseconds(600);
constexpr double kStep_px = 2.0;    // a picture, of what moves
constexpr double kSeenShare = 0.9;  // of an LED's light, below which it is hidden in part
constexpr double kSamePlace_mm = 10.0;
constexpr Duration kHiddenFor = std::chrono::milliseconds(150);  // so long pictures take part in poses

struct Row {
  std::string name;
  ClutterChoice choice;
  bool moving = false;
};

struct Tally {
  int views = 0;
  int asked = 0;
  int found = 0;
  int false_points = 0;
  int reflections = 0;  ///< of LEDs, which blink as they do
  int wrong_ids = 0;
  int verdicts = 0;
  int poses = 0;
  int wrong_poses = 0;      ///< for no such reason as the next two
  int reflected_poses = 0;  ///< of an LED's image in a mirror
  int hidden_poses = 0;     ///< of an LED that was just hidden in part

  [[nodiscard]] double found_share() const { return found / std::max(1.0, asked * 1.0); }
  [[nodiscard]] double per_view(int points) const { return points / std::max(1.0, views * 1.0); }
  [[nodiscard]] double pose_share() const { return poses / std::max(1.0, verdicts * 1.0); }
};

/// Across the view, from where the seed has placed the target.
Trajectory sideways(const Trajectory& still, double focal_px, double rate_hz, TimePoint middle) {
  return {.period = std::chrono::hours{1}, .reference_from_target = [=](double phase_s) {
            Isometry3 pose = still.reference_from_target(0.0);
            const double speed_mm_per_s = kStep_px * rate_hz * pose.translation().z() / focal_px;
            pose.translation().x() += speed_mm_per_s * (phase_s - seconds(middle.time_since_epoch()));
            return pose;
          }};
}

SimulationSettings settings_of(const Row& row, std::uint64_t seed) {
  SimulationSettings settings = clutter_settings(seed, row.choice);
  settings.exposure = std::chrono::milliseconds(2);
  settings.clocks.right.phase = std::chrono::milliseconds(7);
  if (row.moving) {
    settings.trajectory = sideways(settings.trajectory, settings.rig.cameras.left.focal_px.mean(), settings.rate_hz,
                                   SteppedUnit::kStart + kProving + kScored / 2);
  }
  return settings;
}

void count(Tally& tally, const Observation& believed, const FrameTruth& truth, const SimulatedWorld& world) {
  Detection detection;
  detection.points = believed.points;
  const ViewScore score = view_score(detection, {}, truth, world);
  ++tally.views;
  for (const LedScore& led : score.leds) {
    ++tally.asked;
    tally.found += led.found ? 1 : 0;
  }
  for (std::size_t i = 0; i < score.points.size(); ++i) {
    const PointScore& point = score.points[i];
    tally.reflections += point.origin == Origin::kReflection ? 1 : 0;
    tally.false_points += point.origin != Origin::kLed && point.origin != Origin::kReflection ? 1 : 0;
    const int told = believed.points[i].led;
    tally.wrong_ids += told != 0 && point.origin == Origin::kLed && told != point.led ? 1 : 0;
  }
}

/// What a scene lately showed that leads poses astray whatever blinks.
struct Astray {
  TimePoint hidden_until{};            ///< the LED was hidden in part: part of a spot has its centre elsewhere
  std::vector<Vec3> reflections_mm{};  ///< where mirrors show LEDs
};

void learn(Astray& astray, const FrameTruth& truth, const SimulatedWorld& world) {
  astray.reflections_mm.clear();
  for (std::size_t i = 0; i < truth.lights.size(); ++i) {
    const LightTruth& light = truth.lights[i];
    if (light.id != 0 && light.visible_share < kSeenShare) astray.hidden_until = truth.exposed + kHiddenFor;
    if (world.settings().scene.lights[i].mirror) astray.reflections_mm.push_back(light.in_reference_mm);
  }
}

void count(Tally& tally, const Measurement& verdict, const SimulationSettings& settings, const Astray& astray) {
  ++tally.verdicts;
  if (!verdict.pose) return;
  ++tally.poses;
  const Isometry3 truth = target_pose_at(settings.trajectory, verdict.exposed.time_since_epoch());
  if (!is_wrong(pose_error(*verdict.pose, truth))) return;
  const Vec3& place_mm = verdict.pose->position_in_output_mm;
  const bool reflected = std::ranges::any_of(astray.reflections_mm, [&](const Vec3& reflection_mm) {
    return (place_mm - reflection_mm).norm() < kSamePlace_mm;
  });
  if (reflected) {
    ++tally.reflected_poses;
  } else {
    ++(verdict.exposed <= astray.hidden_until ? tally.hidden_poses : tally.wrong_poses);
  }
}

Tally tally_of(const Row& row, std::uint64_t scenes, std::uint64_t first_seed, bool modulated) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    const SimulationSettings settings = settings_of(row, seed);
    bool scored = false;
    Astray astray;
    const auto picture = [&](const Observation& believed, const FrameTruth& truth, const SimulatedWorld& world) {
      learn(astray, truth, world);
      if (scored && !believed.leds_out) count(tally, believed, truth, world);
    };
    const auto verdict = [&](const Measurement& measured) {
      if (scored) count(tally, measured, settings, astray);
    };
    SteppedUnit unit(settings, clutter_model(settings), modulated ? std::optional(Switching{}) : std::nullopt,
                     {picture, verdict});
    unit.run_for(kProving);
    scored = true;
    unit.run_for(kScored);
  }
  return tally;
}

std::vector<Row> rows() {
  const auto choice = [](int leds, double white, Range peak) {
    return ClutterChoice{.min_leds = leds,
                         .max_leds = leds == 1 ? 1 : 4,
                         .white_level = {white, white},
                         .led_peak = peak,
                         .red_lamp_probability = 1.0};
  };
  return {{"one_led", choice(1, 0.05, {1.0, 3.0}), false},
          {"one_led_moving", choice(1, 0.05, {1.0, 3.0}), true},
          {"three_or_four", choice(3, 0.05, {1.0, 3.0}), false},
          {"three_or_four_moving", choice(3, 0.05, {1.0, 3.0}), true},
          {"brighter", choice(3, 0.3, {3.0, 3.0}), false},
          {"bright", choice(3, 0.8, {8.0, 8.0}), false}};
}

void print_row(const std::string& name, const char* how, const Tally& tally) {
  std::fprintf(stderr, "%-22s %-8s %6d %6.4f %6.3f %6.3f %5d | %8d %6.3f %6d %6d %6d\n", name.c_str(), how, tally.asked,
               tally.found_share(), tally.per_view(tally.reflections), tally.per_view(tally.false_points),
               tally.wrong_ids, tally.verdicts, tally.pose_share(), tally.wrong_poses, tally.reflected_poses,
               tally.hidden_poses);
}

void add_figures(std::vector<Figure>& figures, const std::string& row, const Tally& without, const Tally& with) {
  const auto name = [&](const char* what) { return std::string("modulation_") + what + "_" + row; };
  figures.push_back(
      {.name = name("found_share"), .value = with.found_share(), .unit = "share", .baseline = without.found_share()});
  figures.push_back(at_most({.name = name("false_points"),
                             .value = with.per_view(with.false_points),
                             .unit = "per view",
                             .baseline = without.per_view(without.false_points)},
                            0.0));
  figures.push_back(at_most({.name = name("wrong_poses"),
                             .value = static_cast<double>(with.wrong_poses),
                             .unit = "poses",
                             .baseline = static_cast<double>(without.wrong_poses)},
                            0.0));
  figures.push_back(
      {.name = name("pose_share"), .value = with.pose_share(), .unit = "share", .baseline = without.pose_share()});
}

int run(std::uint64_t scenes, std::uint64_t first_seed) {
  std::fprintf(stderr, "%-22s %-8s %6s %6s %6s %6s %5s | %8s %6s %6s %6s %6s\n", "", "", "LEDs", "found", "mirror",
               "others", "ids", "verdicts", "poses", "wrong", "mirror", "hidden");
  std::vector<Figure> figures;
  for (const Row& row : rows()) {
    const Tally without = tally_of(row, scenes, first_seed, false);
    print_row(row.name, "steady", without);
    const Tally with = tally_of(row, scenes, first_seed, true);
    print_row("", "blinking", with);
    add_figures(figures, row.name, without, with);
  }
  print(figures);
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int argc, char** argv) {
  const std::uint64_t scenes = argc > 1 ? std::stoull(argv[1]) : 20;
  const std::uint64_t first_seed = argc > 2 ? std::stoull(argv[2]) : 1;
  return tripoint::bench::run(scenes, first_seed);
}
