#include "modulation/place_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "values/assert.h"

namespace tripoint {
namespace {

constexpr double kRingGap_px = 4.0;
constexpr std::size_t kRingSamples = 24;

}  // namespace

std::optional<int> PlaceLight::contrast(const Picture& picture, const RawPixel& place, double radius_px) {
  TRIPOINT_ASSERT(radius_px <= kMaxRadius_px);
  const double ring_px = radius_px + kRingGap_px;
  const bool inside = place.u_px >= ring_px && place.v_px >= ring_px &&
                      place.u_px <= picture.size.width_px - 1 - ring_px &&
                      place.v_px <= picture.size.height_px - 1 - ring_px;
  if (!inside) return std::nullopt;
  const int u_px = static_cast<int>(std::lround(place.u_px));
  const int v_px = static_cast<int>(std::lround(place.v_px));
  window_.load(picture, u_px, v_px, static_cast<int>(std::ceil(ring_px)) + 1);
  const auto at = [&](int u, int v) {
    return window_.strength(SpotWindow::index(u - window_.left_px(), v - window_.top_px()));
  };
  const int reach = static_cast<int>(std::ceil(radius_px));
  int strongest = 0;
  for (int v = v_px - reach; v <= v_px + reach; ++v) {
    for (int u = u_px - reach; u <= u_px + reach; ++u) {
      if (std::hypot(u - place.u_px, v - place.v_px) <= radius_px) strongest = std::max(strongest, at(u, v));
    }
  }
  std::array<int, kRingSamples> ring{};
  for (std::size_t i = 0; i < kRingSamples; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kRingSamples;
    ring[i] = at(static_cast<int>(std::lround(place.u_px + ring_px * std::cos(angle_rad))),
                 static_cast<int>(std::lround(place.v_px + ring_px * std::sin(angle_rad))));
  }
  std::nth_element(ring.begin(), ring.begin() + kRingSamples / 2, ring.end());
  return strongest - ring[kRingSamples / 2];
}

}  // namespace tripoint
