#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/triangulation.h"
#include "random.h"
#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_calibration;
using testing::Noise;
using testing::seen_exactly;

constexpr PerSide<ImageSize> kSizes{{640, 480}, {640, 480}};

Vec3 point_with(const RigParameters& parameters, const PerSide<MeasuredPixel>& seen) {
  return triangulated(rig_of(calibration_of(parameters, kSizes)).value(), seen)->in_rig_mm;
}

/// Independent of the code under test: the whole way from parameters to point, once above and once below.
Vec3 slope(const StereoCalibration& calibration, const PerSide<MeasuredPixel>& seen, int parameter, double step) {
  RigParameters above = parameters_of(calibration);
  RigParameters below = above;
  above[parameter] += step;
  below[parameter] -= step;
  return (point_with(above, seen) - point_with(below, seen)) / (2.0 * step);
}

double step_of(int parameter) {
  if (parameter >= 21) return 1e-2;        // mm
  if (parameter >= 18) return 1e-4;        // rad
  return parameter % 9 < 4 ? 1e-2 : 1e-3;  // px, then distortion coefficients
}

TEST(CalibrationJacobianTest, EachColumnIsTheSlopeOfTheWholeTriangulation) {
  const StereoCalibration calibration = general_calibration();
  const auto seen = seen_exactly(testing::general_rig(), {60.0, -70.0, 380.0}, 0.1);
  const auto jacobian = calibration_jacobian(calibration, seen);
  for (int i = 0; i < 24; ++i) {
    // Central differences: relative error (step / scale)^2 with scales of 100 mm, 0.3 rad, 100 px, 1.
    const Vec3 expected = slope(calibration, seen, i, step_of(i));
    EXPECT_NEAR((jacobian.col(i) - expected).norm(), 0.0, 1e-5 * expected.norm() + 1e-9) << "parameter " << i;
  }
}

TEST(CalibrationJacobianTest, WithNoisyPixelsTheErrorStaysOfTheSizeOfTheResidual) {
  const StereoCalibration calibration = general_calibration();
  auto seen = seen_exactly(testing::general_rig(), {60.0, -70.0, 380.0}, 0.1);
  seen.left.at.v_px += 0.3;
  const auto jacobian = calibration_jacobian(calibration, seen);
  for (int i = 0; i < 24; ++i) {
    // What is left out: residual (0.21 px in each picture) / focal length x the depth gain (Z/B)^2 = 14: 0.5 %, twice.
    const Vec3 expected = slope(calibration, seen, i, step_of(i));
    EXPECT_NEAR((jacobian.col(i) - expected).norm(), 0.0, 1e-2 * expected.norm() + 1e-9) << "parameter " << i;
  }
}

TEST(CalibrationJacobianTest, InAParallelRigTheColumnsAreTheClosedForms) {
  const double focal_px = 600.0;
  const double baseline = 100.0;
  const double z = 400.0;
  const StereoCalibration calibration = testing::parallel_calibration(focal_px, baseline);
  const auto seen = seen_exactly(testing::parallel_rig(focal_px, baseline), {0.0, 0.0, z});
  const auto jacobian = calibration_jacobian(calibration, seen);
  // Z = f B / d with d = (u1 - cx1) - (u2 - cx2), B = -tx; at X = 0 the rows are equal and Y = 0.
  const double by_center = z * z / (focal_px * baseline);
  EXPECT_NEAR(jacobian(2, 2), by_center, 1e-6 * by_center);    // left cx up: smaller disparity, farther
  EXPECT_NEAR(jacobian(2, 11), -by_center, 1e-6 * by_center);  // right cx
  EXPECT_NEAR(jacobian(2, 21), -z / baseline, 1e-6 * z / baseline);
  EXPECT_NEAR(jacobian(1, 3), -0.5 * z / focal_px, 1e-6);  // rows: the mean of both cameras
  EXPECT_NEAR(jacobian(1, 12), -0.5 * z / focal_px, 1e-6);
}

TEST(CalibrationJacobianTest, UncertainParametersScatterThePointAsTheJacobianSays) {
  const StereoCalibration calibration = general_calibration();
  const auto seen = seen_exactly(testing::general_rig(), {40.0, 30.0, 400.0}, 0.1);
  RigParameters sigma;
  sigma << 0.5, 0.5, 0.4, 0.4, 2e-3, 3e-3, 1e-4, 1e-4, 1e-3, 0.5, 0.5, 0.4, 0.4, 2e-3, 3e-3, 1e-4, 1e-4, 1e-3,  //
      5e-4, 5e-4, 5e-4, 0.05, 0.05, 0.05;
  Noise noise{21};
  testing::Spread<> spread;
  constexpr int kRuns = 10'000;
  for (int run = 0; run < kRuns; ++run) {
    RigParameters parameters = parameters_of(calibration);
    for (int i = 0; i < 24; ++i) parameters[i] += sigma[i] * noise.normal();
    spread.add(point_with(parameters, seen));
  }
  const auto jacobian = calibration_jacobian(calibration, seen);
  const Matrix3 stated = jacobian * sigma.cwiseAbs2().asDiagonal() * jacobian.transpose();
  // sqrt(2 / runs) = 1.4 %, five times, and 1 % of second order.
  EXPECT_LT(testing::relative_difference(spread.covariance(), stated), 0.08);
}

TEST(CalibrationJacobianDeathTest, PixelsWithoutAPointAreABug) {
  const StereoCalibration calibration = general_calibration();
  const PerSide<MeasuredPixel> seen{{{std::nan(""), 0.0}}, {{320.0, 240.0}}};
  EXPECT_DEATH(static_cast<void>(calibration_jacobian(calibration, seen)), "bug");
}

}  // namespace
}  // namespace tripoint
