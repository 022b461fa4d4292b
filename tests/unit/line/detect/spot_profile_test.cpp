#include "line/detect/spot_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tripoint {
namespace {

double exact(int pixel, double center, double sigma) {
  const double q = 1.0 / (sigma * std::numbers::sqrt2);
  return sigma * std::sqrt(std::numbers::pi / 2.0) *
         (std::erf((pixel + 0.5 - center) * q) - std::erf((pixel - 0.5 - center) * q));
}

TEST(SpotProfileTest, AgreesWithTheErrorFunctionAndItsDerivatives) {
  // Float rounding of numbers up to 2.5 sigma, and 1.5e-7 of the error function's approximation, twice.
  for (const double sigma : {0.4, 0.8, 1.5, 4.0, 20.0}) {
    const double tolerance = 2e-6 * std::max(1.0, sigma);
    for (const double center : {0.0, 3.3, 7.5, 15.9}) {
      const AxisProfile profile(17, center, sigma);
      for (int i = 0; i < 17; ++i) {
        constexpr double kStep = 1e-5;
        EXPECT_NEAR(static_cast<double>(profile.value(i)), exact(i, center, sigma), tolerance);
        const double by_center = (exact(i, center + kStep, sigma) - exact(i, center - kStep, sigma)) / (2 * kStep);
        EXPECT_NEAR(static_cast<double>(profile.by_center()[i]), by_center, tolerance);
        const double by_sigma = (exact(i, center, sigma + kStep) - exact(i, center, sigma - kStep)) / (2 * kStep);
        EXPECT_NEAR(static_cast<double>(profile.by_sigma()[i]), by_sigma, 4.0 * tolerance / sigma);
      }
    }
  }
}

TEST(SpotProfileTest, FarFromTheCentreItIsZeroAndFinite) {
  const AxisProfile profile(80, 2.0, 0.4);
  for (int i = 10; i < 80; ++i) EXPECT_NEAR(profile.value(i), 0.0F, 1e-6F);
}

}  // namespace
}  // namespace tripoint
