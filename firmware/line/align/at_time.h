// One camera's points at a given moment.
#pragma once

#include <cstddef>

#include "line/align/align.h"

namespace tripoint {

struct PointsAtTime {
  FixedVector<AlignedPoint, kMaxImagePoints> points;
  Faults faults;                            ///< why a point of the picture is not among them
  std::size_t spots = 0;                    ///< in that picture
  const TrackedPicture* picture = nullptr;  ///< the first picture at or after the moment; never null
  TimePoint exposure_began{};               ///< of the pictures that took part, the one that began first
};

/// Middle of the exposure of a row.
TimePoint time_of_row(const StampClock& clock, const TrackedPicture& picture, double row_px);

/// Points of the first picture at or after `time`, moved back to it along the straight line to the picture before.
/// A point that newly appeared after `time` is left out.
///
/// @param track           not empty; its newest picture is not before `time`
/// @param offset_sigma_s  standard deviation of the time itself, for timing_px2
PointsAtTime points_at_time(const Track& track, const StampClock& clock, TimePoint time, double offset_sigma_s);

}  // namespace tripoint
