// How often a target among other lights is identified, and how often wrongly, over many views from a seed.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "sim/target_view.h"
#include "values/linear.h"

namespace tripoint::bench {

/// Three LEDs of 100, 80, 60 mm; three of 60, 54, 48 mm; four, one of them out of the plane of the others.
struct ScoredTarget {
  std::string_view name;
  std::span<const Vec3> leds_mm;
};
std::span<const ScoredTarget> scored_targets();

struct IdentityScore {
  int views = 0;
  int whole = 0;        ///< of these all of the target is seen
  int found = 0;        ///< of the whole ones: identified, and each point rightly
  int wrong = 0;        ///< of all: an identity was believed that is not the target's
  int wrong_alone = 0;  ///< the same, had nothing to be confirmed
};

/// Views with the seeds from `first_seed` on, each after another of the same scene a sixtieth of a second before it,
/// through the line's own stages with an exact calibration.
IdentityScore identity_score(std::span<const Vec3> leds_mm, const ViewSettings& settings, std::uint64_t first_seed,
                             int views);

}  // namespace tripoint::bench
