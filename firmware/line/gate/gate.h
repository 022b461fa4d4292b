// The only door to the outside: decides whether there is a pose, and says every reason why not.
#pragma once

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/pose/pose.h"

namespace tripoint {

/// Joins what the stages found. A pose passes only without any fault; time, points, residuals and causes always do.
/// Adds kNoCalibration, kCalibrationDoesNotFit, kOutsideVolume, kTimingBound, and kInternal when a value is not a
/// number, which then does not leave. Sequence, speed and lasting warnings are not its business.
Measurement gate(const Aligned& seen, const Pairs& pairs, const Fit& fit, const LineModel& model);

}  // namespace tripoint
