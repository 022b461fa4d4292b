#include "sim/normal_integral.h"

#include <cmath>
#include <numbers>

namespace tripoint {

NormalIntegral::NormalIntegral() {
  values_.reserve(kLastStep + 1);
  for (int i = 0; i <= kLastStep; ++i) {
    const double z = static_cast<double>(i) / kStepsPerUnit - static_cast<double>(kReach);
    values_.push_back(static_cast<float>(0.5 * std::erfc(-z / std::numbers::sqrt2)));
  }
}

}  // namespace tripoint
