// How the target moves, learned from its successive positions.
#pragma once

#include <optional>

#include "line/measurement.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

struct PredictedPosition {
  Vec3 in_output_mm = Vec3::Zero();
  Matrix3 covariance_mm2 = Matrix3::Zero();
  Vec3 velocity_mm_per_s = Vec3::Zero();  ///< zero while unknown
};

/// Constant velocity: on robot-like moves it predicts better than constant acceleration.
class Motion {
 public:
  void take(TimePoint at, const TargetPose& pose);
  void forget() { *this = Motion{}; }

  /// Nothing until two positions are known.
  [[nodiscard]] std::optional<double> speed_mm_per_s() const;
  /// Slower than the limit since long enough.
  [[nodiscard]] bool settled(double limit_mm_per_s) const;
  /// Variance as P + tau^2 Pv + (a tau^2 / 2)^2; nothing before the first position or too far from the newest.
  [[nodiscard]] std::optional<PredictedPosition> position_at(TimePoint at) const;

 private:
  std::optional<TimePoint> newest_;
  Vec3 position_mm_ = Vec3::Zero();
  Matrix3 covariance_mm2_ = Matrix3::Zero();
  Vec3 velocity_mm_per_s_ = Vec3::Zero();
  double known_for_s_ = 0.0;  // time over which the velocity was learned
};

}  // namespace tripoint
