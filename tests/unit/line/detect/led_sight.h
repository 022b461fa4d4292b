// What the detector of LEDs, with its defaults, sees in one painted picture, and how to judge it.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "bench/painter.h"
#include "line/detect/led_detector.h"

namespace tripoint::test {

struct Seen {
  Detection detection;
  CandidateLog log;
};

inline Seen seen_in(const Picture& picture) {
  LedDetector detector{LedDetectorSettings{}};
  const Detection detection = detector.detect(picture, {});
  return {detection, detector.candidates()};
}

/// With the noise of this seed.
inline Seen seen_in(const bench::Painting& painting, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const auto picture = painting.develop({}, random);
  return seen_in(picture.view());
}

/// The log holds a candidate within 12 px, the radius of the largest spot these tests paint, that was dropped.
inline bool refused_near(const CandidateLog& log, const RawPixel& place) {
  return std::any_of(log.begin(), log.end(), [&](const Candidate& candidate) {
    const bool dropped = candidate.cause != DropCause::kKept && candidate.cause != DropCause::kSeenBefore;
    return dropped && std::hypot(candidate.at.u_px - place.u_px, candidate.at.v_px - place.v_px) < 12.0;
  });
}

/// Error over the stated standard deviation; chi2 of two axes.
inline double chi2(const ImagePoint& point, const RawPixel& truth) {
  const Vec2 error(point.at.u_px - truth.u_px, point.at.v_px - truth.v_px);
  return error.dot(point.covariance_px2.inverse() * error);
}

inline constexpr double kChi2Limit = 23.0;  // two axes, 1 in 100 000

}  // namespace tripoint::test
