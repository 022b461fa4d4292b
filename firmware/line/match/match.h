// Which spot of the left picture and which of the right are one point: by geometry and identity, never by guessing.
#pragma once

#include <cstddef>
#include <optional>

#include "line/align/align.h"
#include "line/measurement.h"
#include "line/model.h"
#include "values/fixed_vector.h"
#include "values/side.h"

namespace tripoint {

inline constexpr std::size_t kMaxMatchedSpots = 12;  ///< a side; more are not matched but refused

/// Two image points that belong together, and to nothing else.
struct Pair {
  int id = 0;  ///< point of the target, 0 = not identified; of tags the tag
  PerSide<AlignedPoint> points;
  double epipolar_px = 0.0;
  double epipolar_sigma_px = 0.0;
};

struct Pairs {
  FixedVector<Pair, kMaxImagePoints> pairs;  ///< of LEDs at most kMaxMatchedSpots
  Faults faults;
  std::optional<Pair> datum = std::nullopt;  ///< never one of `pairs`
};

/// Pairs within the epipolar gate and the depth range of the working volume. LEDs that are known by their blinking pair
/// with themselves alone. Otherwise a single point is identified when there is exactly one possible pair, and three or
/// more as `identify` says; two stay ambiguous.
///
/// @return kNotSeenLeft/Right  no spot there;  kEpipolarGate  spots on both sides, none belong together
///         kOutsideVolume      a pair, but not at a depth of the volume
///         kGeometryGate       a pair whose rays do not meet in front of both cameras, or no order that is the target
///         kAmbiguous          a spot with two partners, more spots than can be matched, no identity that is unique,
///                             more than one pair that could be the datum
/// Of a target of tags as `match_tags` says.
Pairs match(const Aligned& seen, const LineModel& model);

}  // namespace tripoint
