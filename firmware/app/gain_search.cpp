#include "app/gain_search.h"

#include <algorithm>

namespace tripoint {

Result<std::optional<int>> lowest_gain(const GainRange& offered, int from, const LightEnough& light_enough) {
  int too_dark = (from - offered.lowest) / offered.step;  // in steps above the lowest
  const int last = (offered.highest - offered.lowest) / offered.step;
  std::optional<int> enough;
  for (int stride = 1; too_dark < last && !enough; stride *= 2) {
    const int tried = std::min(last, too_dark + stride);
    const Result<bool> answer = light_enough(offered.lowest + tried * offered.step);
    if (!answer) return tl::make_unexpected(answer.error());
    (*answer ? enough.emplace() : too_dark) = tried;
  }
  while (enough && *enough - too_dark > 1) {
    const int tried = (too_dark + *enough) / 2;
    const Result<bool> answer = light_enough(offered.lowest + tried * offered.step);
    if (!answer) return tl::make_unexpected(answer.error());
    (*answer ? *enough : too_dark) = tried;
  }
  if (!enough) return std::optional<int>{};
  return std::optional<int>{offered.lowest + *enough * offered.step};
}

}  // namespace tripoint
