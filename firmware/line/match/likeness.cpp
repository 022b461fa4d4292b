#include "line/match/likeness.h"

namespace tripoint {
namespace {

// Room for two cameras that are focused and exposed a little differently and see a LED from two sides.
constexpr double kMostSizeRatio = 2.0;
constexpr double kMostBrightnessRatio = 4.0;

bool within_ratio(double a, double b, double most) { return a <= most * b && b <= most * a; }

}  // namespace

bool alike(const ImagePoint& left, const ImagePoint& right) {
  if (left.saturated || right.saturated) return true;
  const bool sizes = within_ratio(left.sigma_px, right.sigma_px, kMostSizeRatio);
  return sizes && (left.weak != right.weak || within_ratio(left.amplitude, right.amplitude, kMostBrightnessRatio));
}

}  // namespace tripoint
