#include "sim/random_key.h"

#include <cmath>
#include <numbers>

namespace tripoint {

double normal_from(std::uint64_t key) {
  const double first = (static_cast<double>(mixed(key) >> 11U) + 0.5) * 0x1p-53;
  const double second = static_cast<double>(mixed(~key) >> 11U) * 0x1p-53;
  return std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * std::numbers::pi * second);
}

}  // namespace tripoint
