// Brings both cameras' points to one common time: the earlier of the two newest pictures.
#pragma once

#include <cstdint>
#include <optional>

#include "line/align/clocks.h"
#include "line/align/tracks.h"
#include "line/measurement.h"
#include "line/observation.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// An image point at the common time.
struct AlignedPoint {
  ImagePoint seen;                        ///< covariance of the place alone, interpolation included
  std::optional<Vec2> velocity_px_per_s;  ///< absent = unknown; timing_px2 then allows for any usual speed
  Matrix2 timing_px2 = Matrix2::Zero();   ///< what time adds: the clocks' unknown offset, in one camera only, and bends
  double averaging = 1.0;                 ///< that covariance over one picture's: between two pictures down to a half
};

/// What both cameras saw at one moment.
struct Aligned {
  bool due = false;          ///< a verdict has to be published
  bool common_time = false;  ///< there is a new common time
  TimePoint at{};
  TimePoint exposure_began{};  ///< of the pictures that took part, the one that began first
  Faults faults;
  Warnings warnings;
  PerSide<FixedVector<AlignedPoint, kMaxImagePoints>> points;
  PerSide<ImageHealth> health;
  PerSide<std::uint16_t> spots{0, 0};  ///< in the pictures used, aligned or not
  Side timed = Side::kRight;           ///< the camera that carries timing_px2
  double skew_s = 0.0;                 ///< right minus left, newest pictures
  double offset_sigma_s = 0.0;
};

/// In one camera the points are taken as measured, in the other interpolated on a straight line between the two
/// pictures around that time. Rows of a rolling shutter have their own times.
///
/// @return not due when the last event brought no new common time and neither lost nor returned a camera;
///         kAmbiguous when a point cannot be followed from picture to picture, kTimingBound when the pictures around
///         the common time lie too far apart, kInternal when an observation held numbers that are none
Aligned align(const Tracks& tracks, const Clocks& clocks);

}  // namespace tripoint
