#include "line/monitor/motion.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kMemory_s = 0.05;                  // of the velocity: three common times at 30 fps
constexpr double kForget_s = 0.5;                   // without a position the motion is unknown again
constexpr double kSettling_s = 0.2;                 // known for so long before anything counts as settled
constexpr double kLeastStep_s = 1e-3;               // positions closer in time say nothing about speed
constexpr double kAcceleration_mm_per_s2 = 2000.0;  // standard deviation, robot-like moves at 250 mm/s
constexpr double kUnknownSpeed_mm_per_s = 300.0;    // standard deviation before a velocity is known

}  // namespace

void Motion::take(TimePoint at, const TargetPose& pose) {
  const double step_s = newest_ ? seconds(at - *newest_) : kForget_s;
  if (step_s >= kForget_s || step_s < 0.0) {
    forget();
  } else if (step_s < kLeastStep_s) {
    return;
  } else {
    const Vec3 step_velocity = (pose.position_in_output_mm - position_mm_) / step_s;
    const double share = known_for_s_ > 0.0 ? 1.0 - std::exp(-step_s / kMemory_s) : 1.0;
    velocity_mm_per_s_ += share * (step_velocity - velocity_mm_per_s_);
    known_for_s_ += step_s;
  }
  newest_ = at;
  position_mm_ = pose.position_in_output_mm;
  covariance_mm2_ = pose.noise.topLeftCorner<3, 3>() + pose.shared.topLeftCorner<3, 3>();
}

std::optional<double> Motion::speed_mm_per_s() const {
  if (known_for_s_ <= 0.0) return std::nullopt;
  return velocity_mm_per_s_.norm();
}

bool Motion::settled(double limit_mm_per_s) const {
  return known_for_s_ >= kSettling_s && velocity_mm_per_s_.norm() < limit_mm_per_s;
}

std::optional<PredictedPosition> Motion::position_at(TimePoint at) const {
  if (!newest_) return std::nullopt;
  const double ahead_s = seconds(at - *newest_);
  if (std::abs(ahead_s) > kForget_s) return std::nullopt;
  const bool known = known_for_s_ > 0.0;
  const double bend_mm = kAcceleration_mm_per_s2 * ahead_s * ahead_s / 2.0;
  const double drift_mm = known ? 0.0 : kUnknownSpeed_mm_per_s * ahead_s;
  // A velocity over the memory carries twice the position's variance over its square.
  const double velocity_share = known ? 2.0 * ahead_s * ahead_s / (kMemory_s * kMemory_s) : 0.0;
  return PredictedPosition{
      position_mm_ + ahead_s * velocity_mm_per_s_,
      (1.0 + velocity_share) * covariance_mm2_ + (bend_mm * bend_mm + drift_mm * drift_mm) * Matrix3::Identity(),
      velocity_mm_per_s_};
}

}  // namespace tripoint
