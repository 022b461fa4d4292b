#include "line/align/stamp_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tripoint {
namespace {

constexpr std::size_t kTrustedStamps = 8;    // fewer cannot show an outlier of 20 to 60 ms
constexpr double kUntrustedJitter_s = 5e-3;  // taken for the jitter until then
constexpr double kPriorJitter_s = 2e-3;      // expected of a camera, with the weight of kPriorWeight stamps
constexpr double kPriorWeight = 4.0;
constexpr double kLeastJitter_s = 20e-6;
constexpr double kSigmaOfMad = 1.4826 * 1.15;  // median deviation to sigma; 1.15 for a window of 16
constexpr double kMedianVariance = 1.57;       // variance of a median against that of a mean
constexpr double kPhaseNoise_s2 = 4e-14;       // (0.2 us)^2 a frame
constexpr double kPeriodNoise_s2 = 4e-20;      // (0.2 ns)^2 a frame: a crystal's wander
constexpr double kRefusedSigmas = 4.5;
constexpr double kRefusedFloor_s = 0.2e-3;
constexpr double kHuberSigmas = 2.0;
constexpr std::size_t kRefusedInARow = 4;  // outliers come alone, a step stays
constexpr double kDriftMemory = 16.0;
constexpr double kDriftLimit = 1.1;  // six standard deviations of such a mean
constexpr std::uint64_t kDriftFrom = 40;

double steps_between(std::uint32_t from, std::uint32_t to) {
  return static_cast<double>(static_cast<std::int32_t>(to - from));
}

template <std::size_t N>
double median(FixedVector<double, N> values) {
  double* const middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void StampClock::take(std::uint32_t frame, TimePoint at) {
  if (count_ == 0) anchor_ = at;
  const Stamp stamp{frame, seconds(at - anchor_)};
  if (count_ == 0 || steps_between(frame_, frame) <= 0.0) {
    restart_with(stamp);
  } else if (count_ < kStartStamps) {
    ++count_;
    window_.push_back(stamp);
    fit_start();
    if (count_ == kStartStamps) window_.clear();
  } else {
    ++count_;
    track(stamp);
  }
}

TimePoint StampClock::time_of(std::uint32_t frame) const {
  return anchor_ + duration_from_seconds(phase_s_ + steps_between(frame_, frame) * period_s_);
}

double StampClock::sigma_s() const { return std::sqrt(covariance_(0, 0)) + doubt_s_; }

void StampClock::restart_with(const Stamp& stamp) {
  window_.clear();
  window_.push_back(stamp);
  count_ = 1;
  fit_start();
}

/// Theil-Sen slope and median phase of the window; covariance as of a least-squares line at its newest end.
void StampClock::fit_start() {
  const std::size_t n = window_.size();
  const std::size_t apart = std::max<std::size_t>(1, n / 3);
  FixedVector<double, kStartStamps * kStartStamps> slopes;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + apart; j < n; ++j) {
      slopes.push_back((window_[j].at_s - window_[i].at_s) / steps_between(window_[i].frame, window_[j].frame));
    }
  }
  // After a restart the period known before is better than that of a few stamps.
  if (n > 1 && (n >= kTrustedStamps || period_s_ <= 0.0)) period_s_ = median(slopes);
  frame_ = window_.back().frame;
  FixedVector<double, kStartStamps> phases;
  for (const Stamp& stamp : window_) phases.push_back(stamp.at_s + steps_between(stamp.frame, frame_) * period_s_);
  phase_s_ = median(phases);
  for (double& phase : phases) phase = std::abs(phase - phase_s_);
  const auto count = static_cast<double>(n);
  const double spread_s = kSigmaOfMad * median(phases);
  jitter_s_ = n < kTrustedStamps
                  ? kUntrustedJitter_s
                  : std::sqrt((kPriorWeight * kPriorJitter_s * kPriorJitter_s + count * spread_s * spread_s) /
                              (kPriorWeight + count));
  const double variance = kMedianVariance * jitter_s_ * jitter_s_;
  const double corner = 6.0 / (count * (count + 1.0));
  const double slope = n > 1 ? 12.0 / (count * (count * count - 1.0)) : 0.0;
  covariance_ << 2.0 * (2.0 * count - 1.0) / (count * (count + 1.0)), n > 1 ? corner : 0.0, n > 1 ? corner : 0.0, slope;
  covariance_ *= variance;
  drift_ = 0.0;
  doubt_s_ = 0.0;
}

void StampClock::track(const Stamp& stamp) {
  predict(steps_between(frame_, stamp.frame));
  frame_ = stamp.frame;
  const double innovation_s = stamp.at_s - phase_s_;
  const double variance_s2 = covariance_(0, 0) + jitter_s_ * jitter_s_;
  const double sigmas = innovation_s / std::sqrt(variance_s2);
  drift_ += (std::clamp(sigmas, -4.0, 4.0) - drift_) / kDriftMemory;
  if (count_ > kDriftFrom && std::abs(drift_) > kDriftLimit) {
    restart_with(stamp);
  } else if (std::abs(innovation_s) > kRefusedSigmas * std::sqrt(variance_s2) + kRefusedFloor_s) {
    doubt(stamp, innovation_s);
  } else {
    correct(innovation_s, variance_s2);
  }
}

void StampClock::predict(double steps) {
  Matrix2 step = Matrix2::Identity();
  step(0, 1) = steps;
  phase_s_ += steps * period_s_;
  covariance_ = (step * covariance_ * step.transpose()).eval();
  covariance_(0, 0) += steps * kPhaseNoise_s2;
  covariance_(1, 1) += steps * kPeriodNoise_s2;
}

void StampClock::correct(double innovation_s, double innovation_variance_s2) {
  window_.clear();
  doubt_s_ = 0.0;
  const double squared = innovation_s * innovation_s / innovation_variance_s2;
  const double learn = std::max(0.01, 1.0 / static_cast<double>(20 + count_));
  // 1.03: what the cap of 9 takes from the mean square of a normal variable
  jitter_s_ = std::max(kLeastJitter_s, jitter_s_ * std::sqrt(1.0 + learn * (std::min(squared, 9.0) * 1.03 - 1.0)));
  const double huber = std::max(1.0, std::sqrt(squared) / kHuberSigmas);
  const Vec2 gain = covariance_.col(0) / (covariance_(0, 0) + jitter_s_ * jitter_s_ * huber);
  phase_s_ += gain.x() * innovation_s;
  period_s_ += gain.y() * innovation_s;
  covariance_ -= (gain * covariance_.row(0)).eval();
  covariance_(1, 0) = covariance_(0, 1);
}

/// One refused stamp is an outlier, unless it is off by a frame: then a number may have been lost. From the second on
/// the clock may have stepped, and after four it has.
void StampClock::doubt(const Stamp& stamp, double innovation_s) {
  window_.push_back(stamp);
  if (window_.size() > 1 || std::abs(innovation_s) > 0.5 * period_s_) doubt_s_ = std::abs(innovation_s);
  if (window_.size() < kRefusedInARow) return;
  count_ = window_.size();
  fit_start();
}

}  // namespace tripoint
