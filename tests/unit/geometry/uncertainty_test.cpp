// Monte Carlo: what is stated to first order is what noise really does.
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "geometry/paper.h"
#include "geometry/triangulation.h"
#include "random.h"
#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_rig;
using testing::Noise;
using testing::relative_difference;
using testing::seen_exactly;
using testing::Spread;

constexpr int kRuns = 20'000;
// A sampled variance scatters by sqrt(2 / runs) = 1 %; five of these over six entries, and 0.5 % of second order.
constexpr double kTolerance = 0.055;

PerSide<MeasuredPixel> unevenly_seen(const Rig& rig, const Vec3& point) {
  PerSide<MeasuredPixel> seen = seen_exactly(rig, point);
  seen.left.covariance_px2 << 0.010, 0.004, 0.004, 0.005;
  seen.right.covariance_px2 << 0.003, -0.002, -0.002, 0.020;
  return seen;
}

PerSide<MeasuredPixel> disturbed(const PerSide<MeasuredPixel>& seen, Noise& noise) {
  PerSide<MeasuredPixel> moved = seen;
  for (const Side side : kBothSides) {
    const Vec2 error = noise.vector<2>(seen[side].covariance_px2);
    moved[side].at = {seen[side].at.u_px + error.x(), seen[side].at.v_px + error.y()};
  }
  return moved;
}

const Vec3 kPoint{70.0, -50.0, 380.0};

TEST(UncertaintyTest, NoisyPixelsScatterTheBestPointAsItsCovarianceSays) {
  const Rig rig = general_rig();
  const auto seen = unevenly_seen(rig, kPoint);
  Noise noise{11};
  Spread<> spread;
  double chi2_sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const TriangulatedPoint point = triangulated(rig, disturbed(seen, noise)).value();
    spread.add(point.in_rig_mm);
    chi2_sum += point.chi2;
  }
  EXPECT_LT(relative_difference(spread.covariance(), triangulated(rig, seen)->covariance_mm2), kTolerance);
  EXPECT_NEAR(chi2_sum / kRuns, 1.0, kTolerance);  // chi2 of one degree of freedom: mean 1, variance 2
}

TEST(UncertaintyTest, NoisyPixelsScatterThePapersPointAsItsCovarianceSays) {
  const Rig rig = general_rig();
  const auto seen = unevenly_seen(rig, kPoint);
  Noise noise{12};
  Spread<> spread;
  double chi2_sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const TriangulatedPoint point = triangulated_by_paper(rig, disturbed(seen, noise)).value();
    spread.add(point.in_rig_mm);
    chi2_sum += point.chi2;
  }
  EXPECT_LT(relative_difference(spread.covariance(), triangulated_by_paper(rig, seen)->covariance_mm2), kTolerance);
  EXPECT_NEAR(chi2_sum / kRuns, 1.0, kTolerance);
}

TEST(UncertaintyTest, TheEpipolarErrorScattersAsItsVarianceSays) {
  const Rig rig = general_rig();
  const auto seen = unevenly_seen(rig, kPoint);
  Noise noise{13};
  double sum = 0.0;
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const double distance = epipolar_error(rig, disturbed(seen, noise))->distance_px;
    sum += distance;
    squares += distance * distance;
  }
  const double variance = epipolar_error(rig, seen)->variance_px2;
  EXPECT_NEAR(squares / kRuns, variance, kTolerance * variance);
  EXPECT_NEAR(sum / kRuns, 0.0, 5.0 * std::sqrt(variance / kRuns));
}

TEST(UncertaintyTest, NoPointIsBetterThanTheBestOne) {
  // Maximum likelihood: its covariance is the smallest, so the paper's less it has no negative eigenvalue.
  const Rig rig = general_rig();
  const auto seen = unevenly_seen(rig, kPoint);
  const Matrix3 difference = triangulated_by_paper(rig, seen)->covariance_mm2 - triangulated(rig, seen)->covariance_mm2;
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix3>{difference}.eigenvalues().minCoeff(), -1e-12);
  EXPECT_GT(difference.trace(), 0.0);
}

}  // namespace
}  // namespace tripoint
