#include "line/align/clocks.h"

#include <cmath>

namespace tripoint {

void Clocks::take(const Event& event) {
  if (const auto* seen = std::get_if<Observation>(&event)) clocks_[seen->side].take(seen->frame, seen->exposed);
  if (const auto* lost = std::get_if<CameraLost>(&event)) clocks_[lost->side] = StampClock{};
  if (const auto* back = std::get_if<CameraBack>(&event)) clocks_[back->side] = StampClock{};
}

double Clocks::offset_sigma_s() const {
  return std::hypot(offset_prior_s_, clocks_.left.sigma_s(), clocks_.right.sigma_s());
}

}  // namespace tripoint
