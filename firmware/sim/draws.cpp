#include "sim/draws.h"

#include <cmath>

namespace tripoint {

double Draws::scaled(const Range& range) {
  const double share = unit();
  return range.low == range.high ? range.low : range.low * std::pow(range.high / range.low, share);
}

}  // namespace tripoint
