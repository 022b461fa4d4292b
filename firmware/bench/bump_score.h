// How soon a knocked camera is noticed, and how often one that was not.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "bench/erring_units.h"
#include "values/linear.h"
#include "values/side.h"

namespace tripoint::bench {

/// What a unit looks at.
struct Watched {
  std::span<const Vec3> leds_mm;
  std::optional<Vec3> datum_mm = std::nullopt;  ///< in the reference frame; stays where it is
};

/// A turn of one camera about its own lens, or of both together about the middle between them.
struct Bump {
  std::optional<Side> side = Side::kRight;  ///< nothing: both
  Vec3 turn_rad = Vec3::Zero();             ///< rotation vector in that frame: x pitch, y yaw, z roll
};

inline constexpr double kViewsPerSecond = 30.0;

/// A unit of its own, with calibration, target and datum in error, sees its target move among up to two other lights;
/// after two seconds the camera is knocked.
///
/// @return seconds from the knock to the alarm; `limit_s` when there was none before
double seconds_to_alarm(const Watched& watched, const ErrorSources& sources, const Bump& bump, std::uint64_t seed,
                        double limit_s);

/// Alarms of units whose cameras stay where they are: a new one each minute, another scene every two seconds, with up
/// to six other lights, beside mirrors, LEDs hidden.
int alarms_without_cause(const Watched& watched, const ErrorSources& sources, std::uint64_t first_seed,
                         double duration_s);

}  // namespace tripoint::bench
