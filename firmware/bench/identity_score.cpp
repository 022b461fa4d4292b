#include "bench/identity_score.h"

#include <algorithm>
#include <array>

#include "bench/erring_units.h"
#include "line/gate/gate.h"
#include "line/match/match.h"
#include "line/monitor/confirmation.h"
#include "line/pose/pose.h"
#include "sim/default_rig.h"

namespace tripoint::bench {
namespace {

const std::array<Vec3, 3> kTriangle{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};
const std::array<Vec3, 3> kSmall{Vec3(0.0, 0.0, 0.0), Vec3(60.0, 0.0, 0.0), Vec3(24.9, 41.1, 0.0)};
const std::array<Vec3, 4> kFour{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0),
                                Vec3(50.0, 20.0, 40.0)};
const std::array<ScoredTarget, 3> kTargets{
    {{"100/80/60 mm", kTriangle}, {"60/54/48 mm", kSmall}, {"four LEDs", kFour}}};

constexpr double kLedPlace_mm = 0.025;  // standard deviation

/// The LED that a spot of the view is; spots are told by their places, which are drawn and never equal.
int led_at(const TargetView& view, Side side, const AlignedPoint& point) {
  const auto& spots = view.spots[side];
  const auto found = std::find_if(spots.begin(), spots.end(), [&](const ViewedSpot& spot) {
    return spot.at.u_px == point.seen.at.u_px && spot.at.v_px == point.seen.at.v_px;
  });
  return found == spots.end() ? ViewedSpot::kNoLed : found->led;
}

bool all_right(const Pairs& pairs, const TargetView& view) {
  return std::all_of(pairs.pairs.begin(), pairs.pairs.end(), [&](const Pair& pair) {
    return led_at(view, Side::kLeft, pair.points.left) == pair.id - 1 &&
           led_at(view, Side::kRight, pair.points.right) == pair.id - 1;
  });
}

struct Verdict {
  bool accepted = false;  ///< by match
  bool believed = false;  ///< as the line says it
  bool right = false;     ///< every point of the target under its own id
};

class Watch {
 public:
  Watch(std::span<const Vec3> leds_mm, const ViewSettings& settings)
      : leds_(leds_mm.size()),
        settings_(settings),
        model_(model_of(leds_mm, default_rig(), RigCovariance::Zero(), kLedPlace_mm)) {}

  [[nodiscard]] const Rig& rig() const { return model_.rig; }

  Verdict verdict_on(const TargetView& view, TimePoint at) {
    Aligned seen = as_seen(view, settings_.sigma_px);
    seen.at = at;
    const Pairs pairs = match(seen, model_);
    const Measurement measurement = gate(seen, pairs, pose_of_target(seen, pairs, model_), model_);
    return {measurement.pose.has_value(), confirmation_.judged(measurement).pose.has_value(),
            pairs.pairs.size() == leds_ && all_right(pairs, view)};
  }

 private:
  std::size_t leds_;
  ViewSettings settings_;
  LineModel model_;
  Confirmation confirmation_;
};

}  // namespace

std::span<const ScoredTarget> scored_targets() { return kTargets; }

IdentityScore identity_score(std::span<const Vec3> leds_mm, const ViewSettings& settings, std::uint64_t first_seed,
                             int views) {
  constexpr Duration kPeriod{16'666'667};
  Watch watch(leds_mm, settings);
  TimePoint now{};
  IdentityScore score;
  for (; score.views < views; ++score.views) {
    const auto seed = first_seed + static_cast<std::uint64_t>(score.views);
    now += 2 * Confirmation::kMemory;  // nothing of the last scene counts
    (void)watch.verdict_on(target_view(watch.rig(), leds_mm, settings, seed), now);
    now += kPeriod;
    const TargetView view = target_view(watch.rig(), leds_mm, settings, seed, seconds(kPeriod));
    const Verdict verdict = watch.verdict_on(view, now);
    if (view.whole) ++score.whole;
    if (view.whole && verdict.believed && verdict.right) ++score.found;
    if (verdict.believed && !verdict.right) ++score.wrong;
    if (verdict.accepted && !verdict.right) ++score.wrong_alone;
  }
  return score;
}

}  // namespace tripoint::bench
