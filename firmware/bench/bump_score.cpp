#include "bench/bump_score.h"

#include <cmath>
#include <random>
#include <vector>

#include "line/match/match.h"
#include "line/monitor/decalibration.h"
#include "line/pose/pose.h"
#include "sim/default_rig.h"

namespace tripoint::bench {
namespace {

constexpr int kViewsOfScene = 60;
constexpr int kScenesOfUnit = 30;
constexpr double kFarthest_s = 0.2;  // of its motion
constexpr double kDatumRadius_mm = 20.0;

/// How the cameras stand, and where they have the datum.
struct Stand {
  Rig rig;
  std::optional<Vec3> datum_mm;
};

Stand knocked(const StereoCalibration& truth, const Stand& before, const Bump& bump) {
  const Eigen::AngleAxisd turn(bump.turn_rad.norm(), bump.turn_rad.stableNormalized());
  Stand after = before;
  if (!bump.side) {
    if (after.datum_mm) after.datum_mm = turn.inverse() * *before.datum_mm;
    return after;
  }
  StereoCalibration turned = truth;
  if (*bump.side == Side::kRight) {
    turned.right_from_left.prerotate(turn);
  } else {
    turned.right_from_left.rotate(turn.inverse());
  }
  after.rig = rig_of(turned).value();
  const Side stays = other(*bump.side);
  if (after.datum_mm) {
    after.datum_mm =
        after.rig.camera_from_rig[stays].inverse() * (before.rig.camera_from_rig[stays] * *before.datum_mm);
  }
  return after;
}

/// One unit that watches scenes, one view after the other.
class Watcher {
 public:
  Watcher(LineModel model, const ErrorSources& sources, std::uint64_t seed)
      : model_(std::move(model)), spot_px_(sources.spot_px), random_(seed) {
    decalibration_.watch(model_);
  }

  bool alarmed_by(const TargetView& view, const Stand& stand) {
    now_ += duration_from_seconds(1.0 / kViewsPerSecond);
    Aligned seen = as_seen(view, spot_px_);
    seen.at = now_;
    if (stand.datum_mm) show_datum(seen, stand);
    const Pairs pairs = match(seen, model_);
    decalibration_.learn(seen, pairs, pose_of_target(seen, pairs, model_), model_);
    return decalibration_.judged({}).faults.contains(Fault::kDecalibration);
  }

 private:
  void show_datum(Aligned& seen, const Stand& stand) {
    std::normal_distribution<double> normal(0.0, spot_px_);
    for (const Side side : kBothSides) {
      AlignedPoint point;
      point.seen.at = projected(stand.rig.cameras[side], stand.rig.camera_from_rig[side] * *stand.datum_mm).value();
      point.seen.at.u_px += normal(random_);
      point.seen.at.v_px += normal(random_);
      point.seen.covariance_px2 = spot_px_ * spot_px_ * Matrix2::Identity();
      seen.points[side].push_back(point);
      ++seen.spots[side];
    }
  }

  LineModel model_;
  double spot_px_;
  std::mt19937_64 random_;
  Decalibration decalibration_;
  TimePoint now_ = TimePoint{} + std::chrono::seconds(100);
};

/// A unit's model, its datum in error.
LineModel model_with(const Watched& watched, const ErrorSources& sources, const ErringUnits& units,
                     std::mt19937_64& random) {
  LineModel model = units.model(watched.leds_mm, random);
  if (watched.datum_mm) {
    std::normal_distribution<double> normal(0.0, sources.datum_mm);
    const Vec3 believed_mm = *watched.datum_mm + Vec3::NullaryExpr([&] { return normal(random); });
    model.datum = Datum{believed_mm, 2.0 * sources.datum_mm, kDatumRadius_mm};
  }
  return model;
}

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

double seconds_to_alarm(const Watched& watched, const ErrorSources& sources, const Bump& bump, std::uint64_t seed,
                        double limit_s) {
  const StereoCalibration truth = default_rig();
  const Stand before{rig_of(truth).value(), watched.datum_mm};
  const Stand after = knocked(truth, before, bump);
  const ErringUnits units(truth, sources);
  std::mt19937_64 random(~seed);
  Watcher watcher(model_with(watched, sources, units, random), sources, seed);
  const std::vector<Vec3> target_mm = units.target(watched.leds_mm, random);
  const ViewSettings quiet{.sigma_px = sources.spot_px, .most_others = 2, .hidden_share = 0.0, .mirror_share = 0.0};
  std::uint64_t scene = in_sight(before.rig, target_mm, quiet, seed);
  for (int view = 0; view < kViewsOfScene; ++view) {
    (void)watcher.alarmed_by(target_view(before.rig, target_mm, quiet, scene, to_and_fro_s(view)), before);
  }
  const int most = static_cast<int>(limit_s * kViewsPerSecond);
  for (int view = 0; view < most; ++view) {
    if (view % kViewsOfScene == 0) scene = in_sight(after.rig, target_mm, quiet, scene + 1);
    if (watcher.alarmed_by(target_view(after.rig, target_mm, quiet, scene, to_and_fro_s(view)), after)) {
      return (view + 1) / kViewsPerSecond;
    }
  }
  return limit_s;
}

int alarms_without_cause(const Watched& watched, const ErrorSources& sources, std::uint64_t first_seed,
                         double duration_s) {
  const StereoCalibration truth = default_rig();
  const Stand stand{rig_of(truth).value(), watched.datum_mm};
  const ErringUnits units(truth, sources);
  const ViewSettings crowded{.sigma_px = sources.spot_px};
  const int scenes = static_cast<int>(duration_s * kViewsPerSecond) / kViewsOfScene;
  int alarms = 0;
  for (int first = 0; first < scenes; first += kScenesOfUnit) {
    const auto seed = first_seed + static_cast<std::uint64_t>(first);
    std::mt19937_64 random(~seed);
    Watcher watcher(model_with(watched, sources, units, random), sources, seed);
    const std::vector<Vec3> target_mm = units.target(watched.leds_mm, random);
    bool alarmed = false;
    for (int view = 0; view < kScenesOfUnit * kViewsOfScene; ++view) {
      const auto scene = seed + static_cast<std::uint64_t>(view / kViewsOfScene);
      const bool alarm = watcher.alarmed_by(target_view(stand.rig, target_mm, crowded, scene, at_s(view)), stand);
      if (alarm && !alarmed) ++alarms;
      alarmed = alarm;
    }
  }
  return alarms;
}

}  // namespace tripoint::bench
