// The exposure grid of one camera, learned from its stamps.
#pragma once

#include <cstdint>

#include "values/fixed_vector.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

/// Inside one camera pictures are taken on a regular grid, so the jitter of single stamps does not matter: the time
/// of picture k is phase + k * period, by a robust regression of the stamps on the driver's sequence number. The
/// first stamps are fitted together (Theil & Sen), later ones one by one (a Kalman filter with Huber weights).
class StampClock {
 public:
  /// A number that does not grow, or stamps that jump and stay there, start the regression anew.
  void take(std::uint32_t frame, TimePoint at);

  [[nodiscard]] bool started() const { return count_ > 0; }
  [[nodiscard]] TimePoint time_of(std::uint32_t frame) const;
  /// Standard deviation of the time of the newest picture, without the camera's unknown latency.
  [[nodiscard]] double sigma_s() const;
  /// 0 until two stamps exist.
  [[nodiscard]] Duration period() const { return duration_from_seconds(period_s_); }

 private:
  struct Stamp {
    std::uint32_t frame = 0;
    double at_s = 0.0;  // since anchor_
  };
  static constexpr std::size_t kStartStamps = 16;

  void restart_with(const Stamp& stamp);
  void fit_start();
  void track(const Stamp& stamp);
  void predict(double steps);
  void correct(double innovation_s, double innovation_variance_s2);
  void doubt(const Stamp& stamp, double innovation_s);

  TimePoint anchor_{};
  std::uint32_t frame_ = 0;  // of the newest stamp
  std::uint64_t count_ = 0;  // stamps since the start
  double phase_s_ = 0.0;     // time of frame_ since anchor_
  double period_s_ = 0.0;
  Matrix2 covariance_ = Matrix2::Zero();     // of phase and period, s^2
  double jitter_s_ = 0.0;                    // standard deviation of one stamp
  double drift_ = 0.0;                       // running mean of normalised innovations: finds steps the gate cannot see
  double doubt_s_ = 0.0;                     // size of a jump that is not yet believed
  FixedVector<Stamp, kStartStamps> window_;  // stamps of the start, later those refused in a row
};

}  // namespace tripoint
