// Which point of a picture is which point of the picture before.
#pragma once

#include <optional>
#include <span>

#include "line/observation.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"

namespace tripoint {

/// Where a point comes from. Neither index nor ambiguity: it has newly appeared.
struct Link {
  std::optional<std::size_t> before;  ///< index in the picture before
  bool ambiguous = false;             ///< two explanations are about as good: no claim is made
};

/// Mutual nearest neighbours within a gate; a runner-up less than twice as far makes it ambiguous.
///
/// @param expected  where the points of the picture before should now be, px
/// @param now       the points of the picture, px
/// @return one link for each point of `now`
FixedVector<Link, kMaxImagePoints> linked(std::span<const Vec2> expected, std::span<const Vec2> now, double gate_px);

/// The same for points that carry labels: the one point of the picture before with the same label, within the gate.
/// Ambiguous where a label is there twice.
FixedVector<Link, kMaxImagePoints> linked_by_label(std::span<const ImagePoint> before, std::span<const Vec2> expected,
                                                   std::span<const ImagePoint> now, double gate_px);

}  // namespace tripoint
