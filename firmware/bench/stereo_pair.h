// A stereo pair of three LEDs in motion, and what it takes to measure it: for the benchmarks of whole pairs.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/rig.h"
#include "line/detect/led_detector.h"
#include "values/fixed_vector.h"
#include "values/linear.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint::bench {

inline constexpr std::size_t kLedsOfPair = 3;
inline constexpr Duration kPairPeriod = std::chrono::milliseconds{31};

/// Where they are on the target, which moves without turning; in the order of x.
inline const std::array<Vec3, kLedsOfPair> kLedsOfPair_mm{Vec3(0.0, 0.0, 0.0), Vec3(30.0, 60.0, 10.0),
                                                          Vec3(80.0, 25.0, 0.0)};

using PairBytes = PerSide<std::vector<std::uint8_t>>;

/// 32 pairs, a second of motion, through the default rig of that size.
std::vector<PairBytes> three_leds_in_motion(ImageSize size, PixelFormat format);

/// Detects in both pictures and triangulates every pair on a common epipolar plane.
class PairMeasurer {
 public:
  explicit PairMeasurer(ImageSize size);

  /// @return how many points in space came out
  std::size_t measure(const PerSide<Picture>& pictures);

  /// Of the last pair.
  [[nodiscard]] const PerSide<Detection>& seen() const { return seen_; }
  [[nodiscard]] std::span<const Vec3> in_rig_mm() const { return {in_rig_mm_.begin(), in_rig_mm_.size()}; }
  [[nodiscard]] const Rig& rig() const { return rig_; }

 private:
  Rig rig_;
  PerSide<LedDetector> detectors_{LedDetector{LedDetectorSettings{}}, LedDetector{LedDetectorSettings{}}};
  PerSide<Detection> seen_;
  FixedVector<Vec3, kMaxImagePoints> in_rig_mm_;
};

}  // namespace tripoint::bench
