#include "bench/bump_score.h"

#include <cmath>
#include <random>
#include <vector>

#include "line/match/match.h"
#include "line/monitor/decalibration.h"
#include "sim/default_rig.h"

namespace tripoint::bench {
namespace {

constexpr int kViewsOfScene = 60;
constexpr int kScenesOfUnit = 30;
constexpr double kFarthest_s = 0.2;  // of its motion

StereoCalibration knocked(StereoCalibration truth, const Bump& bump) {
  const Eigen::AngleAxisd turn(bump.turn_rad.norm(), bump.turn_rad.stableNormalized());
  if (bump.side == Side::kRight) {
    truth.right_from_left.prerotate(turn);
  } else {
    truth.right_from_left.rotate(turn.inverse());
  }
  return truth;
}

/// One unit that watches scenes, one view after the other.
class Watcher {
 public:
  Watcher(LineModel model, const ErrorSources& sources) : model_(std::move(model)), spot_px_(sources.spot_px) {
    decalibration_.watch(model_);
  }

  bool alarmed_by(const TargetView& view) {
    now_ += duration_from_seconds(1.0 / kViewsPerSecond);
    Aligned seen = as_seen(view, spot_px_);
    seen.at = now_;
    decalibration_.learn(seen, match(seen, model_), model_);
    return decalibration_.judged({}).faults.contains(Fault::kDecalibration);
  }

 private:
  LineModel model_;
  double spot_px_;
  Decalibration decalibration_;
  TimePoint now_ = TimePoint{} + std::chrono::seconds(100);
};

double at_s(int view) { return view % kViewsOfScene / kViewsPerSecond; }

/// To and fro, so that the target stays in sight.
double to_and_fro_s(int view) { return std::abs(std::remainder(view / kViewsPerSecond, 2.0 * kFarthest_s)); }

/// A scene in which both cameras see the whole target at both ends of its way; seeds from `seed` on are tried.
std::uint64_t in_sight(const Rig& rig, std::span<const Vec3> leds_mm, const ViewSettings& settings,
                       std::uint64_t seed) {
  while (!target_view(rig, leds_mm, settings, seed, 0.0).whole ||
         !target_view(rig, leds_mm, settings, seed, kFarthest_s).whole) {
    ++seed;
  }
  return seed;
}

}  // namespace

double seconds_to_alarm(std::span<const Vec3> leds_mm, const ErrorSources& sources, const Bump& bump,
                        std::uint64_t seed, double limit_s) {
  const StereoCalibration truth = default_rig();
  const Rig before = rig_of(truth).value();
  const Rig after = rig_of(knocked(truth, bump)).value();
  const ErringUnits units(truth, sources);
  std::mt19937_64 random(~seed);
  Watcher watcher(units.model(leds_mm, random), sources);
  const std::vector<Vec3> target_mm = units.target(leds_mm, random);
  const ViewSettings quiet{.sigma_px = sources.spot_px, .most_others = 2, .hidden_share = 0.0, .mirror_share = 0.0};
  std::uint64_t scene = in_sight(before, target_mm, quiet, seed);
  for (int view = 0; view < kViewsOfScene; ++view) {
    (void)watcher.alarmed_by(target_view(before, target_mm, quiet, scene, to_and_fro_s(view)));
  }
  const int most = static_cast<int>(limit_s * kViewsPerSecond);
  for (int view = 0; view < most; ++view) {
    if (view % kViewsOfScene == 0) scene = in_sight(after, target_mm, quiet, scene + 1);
    if (watcher.alarmed_by(target_view(after, target_mm, quiet, scene, to_and_fro_s(view)))) {
      return (view + 1) / kViewsPerSecond;
    }
  }
  return limit_s;
}

int alarms_without_cause(std::span<const Vec3> leds_mm, const ErrorSources& sources, std::uint64_t first_seed,
                         double duration_s) {
  const StereoCalibration truth = default_rig();
  const Rig rig = rig_of(truth).value();
  const ErringUnits units(truth, sources);
  const ViewSettings crowded{.sigma_px = sources.spot_px};
  const int scenes = static_cast<int>(duration_s * kViewsPerSecond) / kViewsOfScene;
  int alarms = 0;
  for (int first = 0; first < scenes; first += kScenesOfUnit) {
    std::mt19937_64 random(~(first_seed + static_cast<std::uint64_t>(first)));
    Watcher watcher(units.model(leds_mm, random), sources);
    const std::vector<Vec3> target_mm = units.target(leds_mm, random);
    bool alarmed = false;
    for (int view = 0; view < kScenesOfUnit * kViewsOfScene; ++view) {
      const auto scene = first_seed + static_cast<std::uint64_t>(first + view / kViewsOfScene);
      const bool alarm = watcher.alarmed_by(target_view(rig, target_mm, crowded, scene, at_s(view)));
      if (alarm && !alarmed) ++alarms;
      alarmed = alarm;
    }
  }
  return alarms;
}

}  // namespace tripoint::bench
