// Where each point of the target will be: what flows back from the line to the detectors, as a numbered value.
#pragma once

#include <cstddef>
#include <cstdint>

#include "values/fixed_vector.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

inline constexpr std::size_t kMaxImagePoints = 48;   ///< spots or tag corners of one picture
inline constexpr std::size_t kMaxTargetPoints = 12;  ///< points of one target, or tags
inline constexpr std::size_t kTagCorners = 4;        ///< of a tag; all of a target's corners are kMaxImagePoints

struct ForecastPoint {
  int id = 0;
  PerSide<RawPixel> at;
  PerSide<Matrix2> covariance_px2;
  PerSide<Vec2> velocity_px_per_s{Vec2::Zero(), Vec2::Zero()};
};

struct Forecast {
  std::uint64_t number = 0;  ///< 0: no forecast yet
  TimePoint at{};
  /// Every point of the target and the datum if it shines, or none at all: whoever looks only there must know where
  /// each of them is.
  FixedVector<ForecastPoint, kMaxImagePoints> points;
};

}  // namespace tripoint
