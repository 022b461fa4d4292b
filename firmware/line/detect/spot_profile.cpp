#include "line/detect/spot_profile.h"

#include <cmath>
#include <numbers>

#include "line/detect/vectors.h"
#include "values/assert.h"

namespace tripoint {
namespace {

/// exp(x) for -80 <= x <= 0; relative error below 3e-7.
Floats4 exp_of_negative(Floats4 x) {
  const Floats4 log2 = x * std::numbers::log2e_v<float>;
  const Ints4 whole = __builtin_convertvector(log2 - 0.5F, Ints4);  // rounds, since log2 <= 0
  const Floats4 f = (log2 - __builtin_convertvector(whole, Floats4)) * std::numbers::ln2_v<float>;
  const Floats4 power =
      1.0F + f * (1.0F + f * (1.0F / 2 + f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120 + f * (1.0F / 720))))));
  return power * reinterpret_cast<Floats4>((whole + 127) << 23);
}

/// erf(|z|) given exp(-z^2). Source: Abramowitz & Stegun 1964, 7.1.26; error below 1.5e-7.
Floats4 erf_of_positive(Floats4 z, Floats4 exp_of_minus_z2) {
  const Floats4 t = 1.0F / (1.0F + 0.3275911F * z);
  const Floats4 series =
      t * (0.254829592F + t * (-0.284496736F + t * (1.421413741F + t * (-1.453152027F + t * 1.061405429F))));
  return 1.0F - series * exp_of_minus_z2;
}

}  // namespace

AxisProfile::AxisProfile(int pixels, double center, double sigma_px) {
  TRIPOINT_ASSERT(pixels > 0 && static_cast<std::size_t>(pixels) + 4 <= kRoom);
  alignas(16) std::array<float, kRoom> integral;  // up to each edge, over sigma sqrt(pi/2)
  alignas(16) std::array<float, kRoom> bell;      // at each edge
  alignas(16) std::array<float, kRoom> slope;     // bell times the edge's place
  const auto sigma = static_cast<float>(sigma_px);
  const float scale = std::numbers::sqrt2_v<float> / 2.0F / sigma;
  Floats4 edge = Floats4{0.0F, 1.0F, 2.0F, 3.0F} - static_cast<float>(center + 0.5);
  for (int i = 0; i <= pixels; i += 4, edge += 4.0F) {
    const Floats4 z = edge * scale;
    const Floats4 far = Floats4{} - 80.0F;
    const Floats4 exponent = -z * z;
    const Floats4 e = exp_of_negative(exponent > far ? exponent : far);
    const Floats4 left = erf_of_positive(z < 0.0F ? -z : z, e);
    const Floats4 signed_erf = z < 0.0F ? -left : left;
    const Floats4 by_place = edge * e;
    std::memcpy(integral.data() + i, &signed_erf, sizeof signed_erf);
    std::memcpy(bell.data() + i, &e, sizeof e);
    std::memcpy(slope.data() + i, &by_place, sizeof by_place);
  }
  const float height = sigma * std::sqrt(std::numbers::pi_v<float> / 2.0F);
  const float per_sigma = 1.0F / sigma;
  for (std::size_t i = 0; i < static_cast<std::size_t>(pixels); ++i) {
    values_[i] = height * (integral[i + 1] - integral[i]);
    by_center_[i] = bell[i] - bell[i + 1];
    by_sigma_[i] = (values_[i] + slope[i] - slope[i + 1]) * per_sigma;
  }
  // The rest of the last vector meets weight 0; it must only be finite.
  for (auto i = static_cast<std::size_t>(pixels); i % 4 != 0; ++i) values_[i] = by_center_[i] = by_sigma_[i] = 0.0F;
}

}  // namespace tripoint
