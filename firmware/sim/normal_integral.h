// The standard normal distribution function, fast.
#pragma once

#include <cstddef>
#include <vector>

namespace tripoint {

/// From a table; error below 1e-6.
class NormalIntegral {
 public:
  NormalIntegral();
  [[nodiscard]] float operator()(float z) const {
    const float place = (z + kReach) * static_cast<float>(kStepsPerUnit);
    if (!(place > 0.0F)) return 0.0F;
    if (!(place < static_cast<float>(kLastStep))) return 1.0F;
    const auto cell = static_cast<std::size_t>(place);
    return values_[cell] + (place - static_cast<float>(cell)) * (values_[cell + 1] - values_[cell]);
  }

 private:
  static constexpr float kReach = 6.0F;  ///< in standard deviations
  static constexpr int kStepsPerUnit = 256;
  static constexpr int kLastStep = static_cast<int>(2.0F * kReach) * kStepsPerUnit;
  std::vector<float> values_;
};

}  // namespace tripoint
