#include "app/exposure_search.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/exposure_steps.h"
#include "app/gain_search.h"
#include "line/detect/exposure_margin.h"

namespace tripoint {
namespace {

using std::chrono::microseconds;

constexpr double kNear = 1.2;            ///< a factor: nearer to the middle of the range need not be
constexpr double kLightestWhite = 0.06;  ///< of clip; source: decision 0008 and the rendered scenes behind the gates
const double kMiddle = std::sqrt(kRecommendedFrom * kRecommendedTo);

std::optional<SeenPeaks> in_both(const Look& look) {
  if (!look.peaks.left || !look.peaks.right) return std::nullopt;
  return SeenPeaks{std::min(look.peaks.left->dimmest, look.peaks.right->dimmest),
                   std::max(look.peaks.left->brightest, look.peaks.right->brightest)};
}

Error not_seen(const Look& last, const ExposureOffer& offered) {
  std::string where;
  for (const Side side : kBothSides) {
    if (last.peaks[side]) continue;
    where += fmt::format("{}camera {} sees {} red spots", where.empty() ? "" : ", ", name(side), last.spots[side]);
  }
  return {ErrorCode::kTimeout,
          fmt::format(
              "the target's LEDs, and nothing else, are seen by both cameras at no exposure from {} to {} us and no "
              "gain from {} to {} ({}); switch them on, show them to both cameras, and cover other red lights",
              offered.shortest.count(), offered.longest.count(), offered.gains.lowest, offered.gains.highest, where)};
}

double factor_to_middle(const SeenPeaks& peaks) {
  return std::clamp(kMiddle / std::sqrt(peaks.dimmest * peaks.brightest), 1.0 / kLargestExposureStep,
                    kLargestExposureStep);
}

/// Goes away from the start to both sides until both cameras see the target; else the last look.
Result<Look> first_sight(const LookAt& look_at, const ExposureOffer& offered, const ExposureSetting& start) {
  Look last;
  for (const microseconds exposure : exposures_around(offered, start.exposure)) {
    Result<Look> look = look_at({exposure, start.gain});
    if (!look || in_both(*look)) return look;
    last = *look;
  }
  return last;
}

/// Changes the exposure until the LEDs have about the middle of what is recommended.
Result<Look> nearer_to_middle(const LookAt& look_at, const ExposureOffer& offered, Look look) {
  ExposureBracket bracket;
  for (int step = 0; step < kMostExposureSteps && in_both(look); ++step) {
    const double factor = factor_to_middle(*in_both(look));
    if (factor < kNear && factor > 1.0 / kNear) break;
    const microseconds next = exposure_within(offered, bracket.next_us(microseconds_of(look.setting.exposure), factor));
    if (next == look.setting.exposure) break;
    Result<Look> better = look_at({next, look.setting.gain});
    if (!better || !in_both(*better)) return better.map([&](const Look&) { return look; });  // the edge of what is seen
    look = *better;
  }
  return look;
}

/// Not seen at any exposure, or below what is recommended at the longest.
bool needs_gain(const Look& look, const ExposureOffer& offered) {
  const std::optional<SeenPeaks> peaks = in_both(look);
  return !peaks ||
         microseconds_of(look.setting.exposure) * kRecommendedFrom / peaks->dimmest > microseconds_of(offered.longest);
}

/// What is seen with the lowest gain that is enough for the longest exposure, or with the highest.
Result<Look> with_more_gain(const LookAt& look_at, const ExposureOffer& offered, const Look& without) {
  Look not_enough = without;
  Look enough;
  const LightEnough light_enough = [&](int gain) {
    return look_at({offered.longest, gain}).map([&](const Look& look) {
      const std::optional<SeenPeaks> peaks = in_both(look);
      const bool is_enough = peaks && peaks->dimmest >= kNear * kRecommendedFrom;
      if (peaks) (is_enough ? enough : not_enough) = look;
      return is_enough;
    });
  };
  const Result<std::optional<int>> gain = lowest_gain(offered.gains, without.setting.gain, light_enough);
  if (!gain) return tl::make_unexpected(gain.error());
  return *gain ? nearer_to_middle(look_at, offered, enough) : Result<Look>(not_enough);
}

/// The mean of a picture stands for white: where even that is too light, white is far above.
std::optional<Error> too_light(const Look& look) {
  for (const Side side : kBothSides) {
    const double level = level_from_luma(look.mean_luma[side]);
    if (level <= kLightestWhite) continue;
    return Error{
        ErrorCode::kOutOfRange,
        fmt::format(
            "too much light around: with {} us and gain {}, as the LEDs need it, the picture of camera {} has {:.0f} "
            "% of clip on average, where even white should have {:.0f} % at most; darken the "
            "surroundings, or brighten the LEDs",
            look.setting.exposure.count(), look.setting.gain, name(side), 100.0 * level, 100.0 * kLightestWhite)};
  }
  return std::nullopt;
}

PlaceBounds bounds_from(const Look& look, const SeenPeaks& peaks) {
  const double exposure_us = microseconds_of(look.setting.exposure);
  return {.shortest_us = exposure_us * kRecommendedFrom / peaks.dimmest,
          .longest_us = exposure_us * kRecommendedTo / peaks.brightest,
          .look = look};
}

}  // namespace

Result<PlaceBounds> bounds_at_place(const LookAt& look_at, const ExposureOffer& offered, const ExposureSetting& start) {
  const ExposureSetting first{exposure_within(offered, microseconds_of(start.exposure)), start.gain};
  Result<Look> look = first_sight(look_at, offered, first).and_then([&](const Look& seen) {
    return nearer_to_middle(look_at, offered, seen);
  });
  if (look && needs_gain(*look, offered)) look = with_more_gain(look_at, offered, *look);
  if (!look) return tl::make_unexpected(look.error());
  if (!in_both(*look)) return tl::make_unexpected(not_seen(*look, offered));
  if (const std::optional<Error> error = too_light(*look)) return tl::make_unexpected(*error);
  return bounds_from(*look, *in_both(*look));
}

Result<ExposureSetting> exposure_for(const PlaceBounds& near_end, const PlaceBounds& far_end,
                                     const ExposureOffer& offered) {
  const int gain = far_end.look.setting.gain;
  const double shortest_us = std::max(near_end.shortest_us, far_end.shortest_us);
  const double longest_us = std::min(near_end.longest_us, far_end.longest_us);
  if (shortest_us > longest_us) {
    return failure(
        ErrorCode::kOutOfRange,
        fmt::format("no exposure suits both ends: from {:.0f} us on no LED is below, and up to {:.0f} us none "
                    "above the recommended range; bring the ends of the volume nearer to each other, or use "
                    "LEDs that shine evenly to all sides",
                    shortest_us, longest_us));
  }
  if (longest_us < microseconds_of(offered.shortest)) {
    return failure(
        ErrorCode::kOutOfRange,
        fmt::format("too bright even at the shortest exposure, {} us, with gain {} (up to {:.1f} us would be "
                    "right); give the LEDs less current, or close the iris",
                    offered.shortest.count(), gain, longest_us));
  }
  if (shortest_us > microseconds_of(offered.longest)) {
    return failure(ErrorCode::kOutOfRange,
                   fmt::format("too dim even at the longest exposure, {} us, with gain {} (from {:.0f} us on would be "
                               "right); give the LEDs more current, bring the target nearer, or open the iris",
                               offered.longest.count(), gain, shortest_us));
  }
  return ExposureSetting{exposure_within(offered, std::sqrt(shortest_us * longest_us)), gain};
}

}  // namespace tripoint
