#include "line/monitor/confirmation.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

constexpr double kSigmas = 4.0;

/// Of a pose's noise, all directions together: of the place (corner 0) or of the attitude (corner 3).
double noise(const TargetPose& pose, int corner) { return std::sqrt(pose.noise.block<3, 3>(corner, corner).trace()); }

}  // namespace

Measurement Confirmation::judged(Measurement measurement) {
  if (!measurement.pose || !measurement.pose->output_from_target) {
    if (measurement.common_time) last_.reset();
    return measurement;
  }
  const Seen now{measurement.exposed, *measurement.pose};
  const bool believed = (last_ && agree(*last_, now)) || (last_believed_ && agree(*last_believed_, now));
  last_ = now;
  if (believed) {
    last_believed_ = now;
  } else {
    measurement.pose.reset();
    for (MeasuredPoint& point : measurement.points) point.id = 0;
    measurement.faults.insert(Fault::kAmbiguous);
  }
  return measurement;
}

void Confirmation::forget() {
  last_.reset();
  last_believed_.reset();
}

bool Confirmation::agree(const Seen& before, const Seen& now) {
  if (now.at <= before.at || now.at - before.at > kMemory) return false;
  const double passed_s = seconds(now.at - before.at);
  const double moved_mm = (now.pose.position_in_output_mm - before.pose.position_in_output_mm).norm();
  const double turned_rad =
      Eigen::AngleAxisd(now.pose.output_from_target.value() * before.pose.output_from_target->transpose()).angle();
  const double may_move_mm = kFastest_mm_per_s * passed_s + kSigmas * (noise(before.pose, 0) + noise(now.pose, 0));
  const double may_turn_rad =
      kFastestTurn_rad_per_s * passed_s + kSigmas * (noise(before.pose, 3) + noise(now.pose, 3));
  return moved_mm <= std::min(may_move_mm, kFarthest_mm) && turned_rad <= std::min(may_turn_rad, kFarthestTurn_rad);
}

}  // namespace tripoint
