// Runs events through a line and compares the verdicts with the truth.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/LU>

#include "line/line.h"
#include "synthetic_cameras.h"

namespace tripoint::testing {

inline std::vector<Measurement> verdicts(Line& line, const std::vector<Event>& events) {
  std::vector<Measurement> found;
  for (const Event& event : events) {
    if (const auto measurement = line.step(event)) found.push_back(*measurement);
  }
  return found;
}

inline std::vector<Measurement> verdicts(const LineModel& model, const std::vector<Event>& events) {
  Line line(shared_model(model));
  return verdicts(line, events);
}

inline double exposed_s(const Measurement& measurement) { return seconds(measurement.exposed.time_since_epoch()); }

struct Score {
  double rms_mm = 0.0;
  double worst_sigmas = 0.0;  ///< largest error over the root of the largest stated variance
  double valid_share = 0.0;
  double inside_share = 0.0;  ///< of the poses whose truth lies within the stated 95 % ellipsoid
  std::size_t verdicts = 0;
};

inline Score score(const std::vector<Measurement>& measurements, const Path& path, double from_s) {
  Score score;
  double squares = 0.0;
  double poses = 0.0;
  double inside = 0.0;
  for (const Measurement& measurement : measurements) {
    if (exposed_s(measurement) < from_s || !measurement.common_time) continue;
    ++score.verdicts;
    if (!measurement.pose) continue;
    const Vec3 error = measurement.pose->position_in_output_mm - path(exposed_s(measurement));
    const Matrix3 covariance = (measurement.pose->noise + measurement.pose->shared).topLeftCorner<3, 3>();
    squares += error.squaredNorm();
    inside += error.dot(covariance.inverse() * error) < 7.815 ? 1.0 : 0.0;  // chi2(3) at 95 %
    poses += 1.0;
    score.worst_sigmas = std::max(score.worst_sigmas, error.norm() / std::sqrt(covariance.diagonal().maxCoeff()));
  }
  score.rms_mm = std::sqrt(squares / poses);
  score.inside_share = inside / poses;
  score.valid_share = poses / static_cast<double>(score.verdicts);
  return score;
}

/// 30 fps each, out of phase and drifting, 3 ms RMS of stamp jitter, 1 % of the pictures dropped.
inline Shooting free_running() {
  Shooting shooting;
  shooting.timing.left = {1.0 / 30.0 * (1.0 + 40e-6), 0.003, 3e-3, 0.01, 0.010};
  shooting.timing.right = {1.0 / 30.0 * (1.0 - 30e-6), 0.017, 3e-3, 0.01, 0.010};
  shooting.duration_s = 40.0;
  return shooting;
}

}  // namespace tripoint::testing
