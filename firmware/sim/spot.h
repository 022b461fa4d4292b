// A Gaussian spot of light, integrated over each pixel in closed form.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/scene.h"
#include "values/linear.h"
#include "values/pixel.h"

namespace tripoint {

/// The standard normal distribution function from a table; error below 1e-6.
class NormalIntegral {
 public:
  NormalIntegral();
  [[nodiscard]] float operator()(float z) const {
    const float place = (z + kReach) * static_cast<float>(kStepsPerUnit);
    if (!(place > 0.0F)) return 0.0F;
    const auto cell = static_cast<std::size_t>(place);
    if (cell + 1 >= values_.size()) return 1.0F;
    return values_[cell] + (place - static_cast<float>(cell)) * (values_[cell + 1] - values_[cell]);
  }

 private:
  static constexpr float kReach = 6.0F;  ///< in standard deviations
  static constexpr int kStepsPerUnit = 256;
  std::vector<float> values_;
};

/// One instant of a spot.
struct GaussianSpot {
  RawPixel at;
  double sigma_px = 1.0;
  LinearColor energy{};             ///< sum over all pixels if each were of that colour, clip x px
  double row_px = 0.0;              ///< the row for whose time `at` holds
  Vec2 shift_px_per_row{0.0, 0.0};  ///< how far the spot moves from the time of a row to that of the next
};

/// Mean light level of each pixel under the mosaic: a fixed background, and spots that come and go.
class LightPlane {
 public:
  /// @param background  mean levels in units of clip, row by row
  LightPlane(ImageSize size, std::span<const float> background);

  /// Adds a spot, out to five standard deviations.
  void add(const GaussianSpot& spot, const NormalIntegral& normal);

  /// Takes all spots out again.
  void clear();

  [[nodiscard]] std::span<const float> row(int y) const;

 private:
  void add_to_row(int y, const GaussianSpot& spot, const NormalIntegral& normal);

  ImageSize size_;
  std::span<const float> background_;
  std::vector<float> levels_;
  int first_touched_;
  int last_touched_{-1};
};

}  // namespace tripoint
