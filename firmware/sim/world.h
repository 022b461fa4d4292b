// The simulated world: everything that two simulated cameras share. It never changes once it is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/rig.h"
#include "sim/normal_integral.h"
#include "sim/painting.h"
#include "sim/sensor.h"
#include "sim/settings.h"
#include "values/result.h"

namespace tripoint {

class SimulatedWorld {
 public:
  /// @param start  when frame 0 of a camera with phase 0 is exposed (middle of row 0), on the monotonic clock
  /// @return kOutOfRange, naming the setting, for sizes that are not multiples of 16, or rates, times and levels that
  ///         no camera has; kDegenerate when the rig is not one
  static Result<SimulatedWorld> create(const SimulationSettings& settings, TimePoint start = TimePoint{});

  [[nodiscard]] const SimulationSettings& settings() const { return settings_; }
  [[nodiscard]] TimePoint start() const { return start_; }
  [[nodiscard]] const Rig& rig() const { return rig_; }
  [[nodiscard]] const NoiseTable& noise() const { return noise_; }
  [[nodiscard]] const NormalIntegral& normal() const { return normal_; }
  /// Where a camera stands at a time since 1970, knocked or not.
  [[nodiscard]] Isometry3 camera_from_reference(Side side, Duration since_1970) const;
  /// What hides lights behind it, the farthest first.
  [[nodiscard]] const std::vector<Figure>& figures(Side side) const { return figures_[side]; }
  /// Places in the picture, row by row.
  [[nodiscard]] const std::vector<std::size_t>& hot_pixels(Side side) const { return hot_pixels_[side]; }
  /// Mean level of each pixel under the mosaic without any light source, row by row, in units of clip.
  [[nodiscard]] const std::vector<float>& background(Side side) const { return backgrounds_[side]; }

 private:
  SimulatedWorld(SimulationSettings settings, TimePoint start, Rig rig);

  SimulationSettings settings_;
  TimePoint start_;
  Rig rig_;
  NoiseTable noise_;
  NormalIntegral normal_;
  PerSide<std::vector<Figure>> figures_;
  PerSide<std::vector<std::size_t>> hot_pixels_;
  PerSide<std::vector<float>> backgrounds_;
};

}  // namespace tripoint
