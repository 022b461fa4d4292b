// One axis of a pixel-integrated Gaussian, with its derivatives, four pixels at a time.
#pragma once

#include <array>
#include <cstddef>

namespace tripoint {

/// For pixel i: the integral over [i - 1/2, i + 1/2] of exp(-(t - center)^2 / (2 sigma^2)), and its derivatives.
/// Absolute error below 2e-7 sigma. Whole vectors of 4 may be read; their rest is not meaningful.
class AxisProfile {
 public:
  AxisProfile(int pixels, double center, double sigma_px);

  [[nodiscard]] float value(int i) const { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const float* values() const { return values_.data(); }
  [[nodiscard]] const float* by_center() const { return by_center_.data(); }
  [[nodiscard]] const float* by_sigma() const { return by_sigma_.data(); }

 private:
  static constexpr std::size_t kRoom = 88;
  alignas(16) std::array<float, kRoom> values_;
  alignas(16) std::array<float, kRoom> by_center_;
  alignas(16) std::array<float, kRoom> by_sigma_;
};

}  // namespace tripoint
