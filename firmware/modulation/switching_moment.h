// When to switch, so that neither camera is exposing what it looks at.
#pragma once

#include <optional>

#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// When one camera exposes the rows in which LEDs are looked for: `middle` +- `half`, again and again.
struct Rhythm {
  TimePoint middle{};
  Duration period{0};
  Duration half{0};  ///< of the exposure, of the time from the first of these rows to the last, and the stamp's error
};

struct SwitchingMoment {
  TimePoint at{};
  Duration clearance{0};  ///< to the nearest exposure; 0 or less: there is no moment at which none is exposing
};

/// One period after `previous`, or at most half a period away from that: the middle of the longest time in which no
/// camera exposes. The time that holds the usual moment is kept while it is at least half as long as the longest one.
/// Where both cameras leave no such time, a tenth of a period later than usual: so each row is clear now and then.
///
/// @param rhythms  of the cameras that deliver, at least one
SwitchingMoment switching_moment(TimePoint previous, const PerSide<std::optional<Rhythm>>& rhythms);

}  // namespace tripoint
