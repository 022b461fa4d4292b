#include "geometry/triangulation.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_rig;
using testing::parallel_rig;
using testing::pixel;
using testing::seen_exactly;
using testing::vec3;
using testing::vectors;

constexpr double kFocalPx = 600.0;
constexpr double kBaselineMm = 100.0;

MeasuredPixel at(double u_px, double v_px, double sigma_px = 1.0) {
  return {{u_px, v_px}, sigma_px * sigma_px * Matrix2::Identity()};
}

ErrorCode error_of(const Rig& rig, const PerSide<MeasuredPixel>& seen) {
  const auto result = triangulated(rig, seen);
  EXPECT_FALSE(result.has_value());
  return result ? ErrorCode::kMalformed : result.error().code;
}

TEST(TriangulationTest, ExactPixelsGiveThePublishedPoints) {
  const Rig rig = general_rig();
  for (const auto& point : vectors("E_general_model", "points")) {
    const auto result = triangulated(rig, {{pixel(point.at("left_px"))}, {pixel(point.at("right_px"))}});
    ASSERT_TRUE(result.has_value());
    // Rounding of the pixels, 6e-14, times at most 5 mm per px, times a few operations.
    const Vec3 in_left = rig.camera_from_rig.left * result->in_rig_mm;
    EXPECT_NEAR((in_left - vec3(point.at("X_left_mm"))).norm(), 0.0, 1e-10);
    EXPECT_NEAR(result->chi2, 0.0, 1e-20);
  }
}

TEST(TriangulationTest, NoisyPixelsGiveThePublishedMaximumLikelihoodPoint) {
  const Rig rig = general_rig();
  const auto truth = vectors("E_general_model").at("noisy_maximum_likelihood");
  const auto result = triangulated(rig, {{pixel(truth.at("left_px"))}, {pixel(truth.at("right_px"))}});
  ASSERT_TRUE(result.has_value());
  const Isometry3& left_from_rig = rig.camera_from_rig.left;
  // The iteration stops at 4e-9 mm steps and gains three digits a step at this residual.
  EXPECT_NEAR((left_from_rig * result->in_rig_mm - vec3(truth.at("X_left_mm"))).norm(), 0.0, 1e-9);
  EXPECT_NEAR(result->chi2, testing::number(truth.at("sum_squared_residual_px2")), 1e-12);
  // The published matrix came from differences: a closed form differs by 3e-10 of its largest entry, 13.
  const Matrix3 in_left = left_from_rig.linear() * result->covariance_mm2 * left_from_rig.linear().transpose();
  EXPECT_NEAR((in_left - testing::matrix3(truth.at("covariance_over_sigma2_mm2_per_px2"))).norm(), 0.0, 1e-8);
}

TEST(TriangulationTest, TheResidualIsMeasuredLessPredicted) {
  const Rig rig = general_rig();
  const auto truth = vectors("E_general_model").at("noisy_maximum_likelihood");
  const PerSide<MeasuredPixel> seen{{pixel(truth.at("left_px"))}, {pixel(truth.at("right_px"))}};
  const TriangulatedPoint result = triangulated(rig, seen).value();
  const RawPixel left = projected(rig.cameras.left, rig.camera_from_rig.left * result.in_rig_mm).value();
  EXPECT_DOUBLE_EQ(result.residual_px.left.x(), seen.left.at.u_px - left.u_px);
  EXPECT_DOUBLE_EQ(result.residual_px.left.y(), seen.left.at.v_px - left.v_px);
  EXPECT_NEAR(result.residual_px.left.squaredNorm() + result.residual_px.right.squaredNorm(), result.chi2, 1e-15);
}

// Parallel axes, equal cameras: columns fit exactly, the common row is the mean weighted by 1/sigma^2.
TEST(TriangulationTest, TheBetterCameraPullsTheRowTowardsItself) {
  const Rig rig = parallel_rig(kFocalPx, kBaselineMm);
  const auto result = triangulated(rig, {at(400.0, 260.0, 0.1), at(250.0, 261.0, 0.3)});
  ASSERT_TRUE(result.has_value());
  const double z = kFocalPx * kBaselineMm / 150.0;
  const double row = 260.0 + 1.0 * 0.01 / (0.01 + 0.09);
  EXPECT_NEAR(result->in_rig_mm.z(), z, 1e-9);
  EXPECT_NEAR(result->in_rig_mm.x(), (400.0 - 320.0) * z / kFocalPx - 0.5 * kBaselineMm, 1e-9);
  EXPECT_NEAR(result->in_rig_mm.y(), (row - 240.0) * z / kFocalPx, 1e-9);
  EXPECT_NEAR(result->chi2, 1.0 / (0.01 + 0.09), 1e-9);
}

TEST(TriangulationTest, TheCovarianceOnTheAxisIsTheClosedFormOfTheErrorBudget) {
  const double z = 400.0;
  const double sigma_px = 0.05;
  const auto seen = seen_exactly(parallel_rig(kFocalPx, kBaselineMm), {0.0, 0.0, z}, sigma_px);
  const Matrix3 covariance = triangulated(parallel_rig(kFocalPx, kBaselineMm), seen)->covariance_mm2;
  const double sigma_x = z * sigma_px / (std::sqrt(2.0) * kFocalPx);
  const double sigma_z = std::sqrt(2.0) * z * z * sigma_px / (kFocalPx * kBaselineMm);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), sigma_x, 1e-9 * sigma_x);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), sigma_x, 1e-9 * sigma_x);
  EXPECT_NEAR(std::sqrt(covariance(2, 2)), sigma_z, 1e-9 * sigma_z);
}

TEST(TriangulationTest, ParallelRaysAreAnError) {
  EXPECT_EQ(error_of(parallel_rig(kFocalPx, kBaselineMm), {at(330.0, 250.0), at(330.0, 250.0)}),
            ErrorCode::kRaysAlmostParallel);
}

TEST(TriangulationTest, TheBorderOfAlmostParallelIsTheAngleGiven) {
  // On the axis the rays meet at 2 atan(B / 2Z).
  const Rig rig = parallel_rig(kFocalPx, kBaselineMm);
  const double z = 0.5 * kBaselineMm / std::tan(0.5 * 0.01);
  EXPECT_TRUE(triangulated(rig, seen_exactly(rig, {0.0, 0.0, z * (1.0 - 1e-6)})).has_value());
  EXPECT_EQ(error_of(rig, seen_exactly(rig, {0.0, 0.0, z * (1.0 + 1e-6)})), ErrorCode::kRaysAlmostParallel);
}

TEST(TriangulationTest, DivergingRaysAreAPointBehindTheCameras) {
  EXPECT_EQ(error_of(parallel_rig(kFocalPx, kBaselineMm), {at(200.0, 240.0), at(350.0, 240.0)}),
            ErrorCode::kBehindCamera);
}

TEST(TriangulationTest, APixelThatCannotBeUndistortedIsAnError) {
  EXPECT_EQ(error_of(general_rig(), {at(std::nan(""), 240.0), at(250.0, 240.0)}), ErrorCode::kNoConvergence);
  Rig folded = parallel_rig(kFocalPx, kBaselineMm);
  folded.cameras.right.distortion = {-0.3, 0.0, 0.0, 0.0, 0.0};  // nothing appears beyond radius 0.7027
  EXPECT_EQ(error_of(folded, {at(320.0, 240.0), at(320.0 - 0.71 * kFocalPx, 240.0)}), ErrorCode::kNoConvergence);
}

TEST(TriangulationTest, ACovarianceThatIsNotPositiveDefiniteIsAnError) {
  const Rig rig = parallel_rig(kFocalPx, kBaselineMm);
  Matrix2 indefinite;
  indefinite << 1.0, 2.0, 2.0, 1.0;
  const Matrix2 zero = Matrix2::Zero();
  const Matrix2 no_number = std::numeric_limits<double>::quiet_NaN() * Matrix2::Identity();
  for (const Matrix2& bad : {indefinite, zero, no_number}) {
    PerSide<MeasuredPixel> seen{at(400.0, 260.0), at(250.0, 260.0)};
    seen.right.covariance_px2 = bad;
    EXPECT_EQ(error_of(rig, seen), ErrorCode::kDegenerate);
  }
}

TEST(EpipolarErrorTest, MatchingPixelsHaveNone) {
  const Rig rig = general_rig();
  const EpipolarError error = epipolar_error(rig, seen_exactly(rig, {20.0, 30.0, 400.0})).value();
  EXPECT_NEAR(error.distance_px, 0.0, 1e-11);
}

TEST(EpipolarErrorTest, InAParallelRigItIsTheRowDifferenceOverRootTwo) {
  // The correction is shared by both pictures: dv/2 each, so the distance in four dimensions is dv / sqrt 2.
  const Rig rig = parallel_rig(kFocalPx, kBaselineMm);
  const EpipolarError error = epipolar_error(rig, {at(400.0, 260.0, 0.1), at(250.0, 261.0, 0.3)}).value();
  EXPECT_NEAR(std::abs(error.distance_px), 1.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(error.variance_px2, 0.5 * (0.01 + 0.09), 1e-12);
}

TEST(EpipolarErrorTest, ItChangesSignWithTheDirectionOfTheMismatch) {
  const Rig rig = parallel_rig(kFocalPx, kBaselineMm);
  const double above = epipolar_error(rig, {at(400.0, 260.0), at(250.0, 259.0)})->distance_px;
  const double below = epipolar_error(rig, {at(400.0, 260.0), at(250.0, 261.0)})->distance_px;
  EXPECT_NEAR(above, -below, 1e-12);
}

TEST(EpipolarErrorTest, SquaredOverItsVarianceItIsTheResidualOfTheBestPoint) {
  const Rig rig = general_rig();
  const auto truth = vectors("E_general_model").at("noisy_maximum_likelihood");
  const EpipolarError error =
      epipolar_error(rig, {{pixel(truth.at("left_px"))}, {pixel(truth.at("right_px"))}}).value();
  // First order: the next term is the residual (0.15 px) over the focal length, 2e-4.
  const double chi2 = testing::number(truth.at("sum_squared_residual_px2"));
  EXPECT_NEAR(error.distance_px * error.distance_px / error.variance_px2, chi2, 1e-3 * chi2);
}

TEST(EpipolarErrorTest, APixelThatCannotBeUndistortedIsAnError) {
  const Rig rig = general_rig();
  EXPECT_EQ(epipolar_error(rig, {at(std::nan(""), 1.0), at(1.0, 1.0)}).error().code, ErrorCode::kNoConvergence);
  EXPECT_EQ(epipolar_error(rig, {at(1.0, 1.0), at(1.0, std::nan(""))}).error().code, ErrorCode::kNoConvergence);
}

TEST(EpipolarErrorTest, BothLookingAlongTheBaselineHasNoEpipolarPlane) {
  // The right camera stands on the axis of the left and looks the same way.
  StereoCalibration calibration = testing::parallel_calibration(kFocalPx, kBaselineMm);
  Rig rig{calibration.cameras, {Isometry3::Identity(), Isometry3::Identity()}};
  rig.camera_from_rig.right.translation() = Vec3{0.0, 0.0, -kBaselineMm};
  EXPECT_EQ(epipolar_error(rig, {at(320.0, 240.0), at(320.0, 240.0)}).error().code, ErrorCode::kDegenerate);
}

}  // namespace
}  // namespace tripoint
