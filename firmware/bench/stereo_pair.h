// A stereo pair of three LEDs in motion, and what it takes to measure it: for the benchmarks of whole pairs.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/rig.h"
#include "line/detect/led_detector.h"
#include "values/side.h"

namespace tripoint::bench {

inline constexpr std::size_t kLedsOfPair = 3;

using PairBytes = PerSide<std::vector<std::uint8_t>>;

/// 32 pairs of 640x480, a second of motion, through the default rig.
std::vector<PairBytes> three_leds_in_motion(PixelFormat format);

/// Detects in both pictures and triangulates every pair on a common epipolar plane.
class PairMeasurer {
 public:
  PairMeasurer();

  /// @return how many points in space came out
  std::size_t measure(const PerSide<Picture>& pictures);

 private:
  Rig rig_;
  PerSide<LedDetector> detectors_{LedDetector{LedDetectorSettings{}}, LedDetector{LedDetectorSettings{}}};
};

}  // namespace tripoint::bench
