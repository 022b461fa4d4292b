#include "sim/draws.h"

#include <cmath>

namespace tripoint {

double Draws::scaled(const Range& range) { return range.low * std::pow(range.high / range.low, unit()); }

}  // namespace tripoint
