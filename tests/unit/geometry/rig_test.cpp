#include "geometry/rig.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_calibration;
using testing::general_rig;
using testing::parallel_calibration;
using testing::parallel_rig;

constexpr double kRoundingMm = 1e-12;  // a dozen operations on numbers of 100 mm, each 1e-14

Matrix3 about_y(double angle_rad) { return Eigen::AngleAxisd{angle_rad, Vec3::UnitY()}.toRotationMatrix(); }

/// Right camera at `center` in the left frame, its axes turned by `rotation`.
StereoCalibration with_right_at(const Vec3& center_in_left, const Matrix3& left_from_right) {
  StereoCalibration calibration = parallel_calibration(600.0, 100.0);
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = left_from_right;
  pose.translation() = center_in_left;
  calibration.right_from_left = pose.inverse();
  return calibration;
}

TEST(RigTest, OriginLiesMidwayBetweenTheLensCentres) {
  const Rig rig = general_rig();
  const Vec3 left = rig.camera_from_rig.left.inverse().translation();
  const Vec3 right = rig.camera_from_rig.right.inverse().translation();
  EXPECT_NEAR((left + right).norm(), 0.0, kRoundingMm);
}

TEST(RigTest, XRunsFromTheLeftCentreToTheRight) {
  const Rig rig = general_rig();
  const Vec3 right = rig.camera_from_rig.right.inverse().translation();
  EXPECT_NEAR(right.x(), 0.5 * std::sqrt(99.6 * 99.6 + 0.2 * 0.2 + 8.7 * 8.7), kRoundingMm);  // |t| of vectors E
  EXPECT_NEAR(right.y(), 0.0, kRoundingMm);
  EXPECT_NEAR(right.z(), 0.0, kRoundingMm);
}

TEST(RigTest, ZIsTheSumOfBothAxesLessItsPartAlongX) {
  const Rig rig = general_rig();
  const Vec3 sum = rig.camera_from_rig.left.linear().transpose() * Vec3::UnitZ() +
                   rig.camera_from_rig.right.linear().transpose() * Vec3::UnitZ();
  EXPECT_NEAR(sum.y(), 0.0, 1e-14);
  EXPECT_GT(sum.z(), 1.9);
}

TEST(RigTest, YPointsDownWhereTheCamerasSayDown) {
  const Vec3 down_in_rig = parallel_rig(600.0, 100.0).camera_from_rig.left.linear().transpose() * Vec3::UnitY();
  EXPECT_NEAR((down_in_rig - Vec3::UnitY()).norm(), 0.0, 1e-15);
}

TEST(RigTest, BothCamerasSitWhereTheCalibrationPutsThem) {
  const StereoCalibration calibration = general_calibration();
  const Rig rig = general_rig();
  const Isometry3 right_from_left = rig.camera_from_rig.right * rig.camera_from_rig.left.inverse();
  EXPECT_NEAR((right_from_left.matrix() - calibration.right_from_left.matrix()).norm(), 0.0, kRoundingMm);
  EXPECT_NEAR(rig.camera_from_rig.left.linear().determinant(), 1.0, 1e-14);
}

TEST(RigTest, AParallelRigIsTheLeftCameraShiftedByHalfTheBaseline) {
  const Vec3 origin_in_left = parallel_rig(600.0, 100.0).camera_from_rig.left * Vec3{1.0, 2.0, 3.0};
  EXPECT_NEAR((origin_in_left - Vec3{51.0, 2.0, 3.0}).norm(), 0.0, kRoundingMm);
}

TEST(RigTest, ARightCameraToedInAcrossTheBaselineDoesNotTurnTheFrame) {
  // The right axis is (-sin 20, 0, cos 20): what it adds along x is taken away again.
  const double angle = 20.0 * std::numbers::pi / 180.0;
  const Rig rig = rig_of(with_right_at({100.0, 0.0, 0.0}, about_y(-angle))).value();
  EXPECT_NEAR((rig.camera_from_rig.left.linear() - Matrix3::Identity()).norm(), 0.0, 1e-14);
}

TEST(RigTest, ARightCameraPitchedAloneTiltsTheFrameByHalf) {
  const double pitch = 0.2;
  const Matrix3 about_x = Eigen::AngleAxisd{pitch, Vec3::UnitX()}.toRotationMatrix();
  const Rig rig = rig_of(with_right_at({100.0, 0.0, 0.0}, about_x)).value();
  const Matrix3 half = Eigen::AngleAxisd{0.5 * pitch, Vec3::UnitX()}.toRotationMatrix();
  EXPECT_NEAR((rig.camera_from_rig.left.linear() - half).norm(), 0.0, 1e-14);
}

TEST(RigTest, CoincidingLensCentresAreAnError) {
  for (const double baseline : {0.0, 0.9e-3}) {
    const auto rig = rig_of(with_right_at({baseline, 0.0, 0.0}, Matrix3::Identity()));
    ASSERT_FALSE(rig.has_value());
    EXPECT_EQ(rig.error().code, ErrorCode::kDegenerate);
  }
  EXPECT_TRUE(rig_of(with_right_at({1.1e-3, 0.0, 0.0}, Matrix3::Identity())).has_value());
}

TEST(RigTest, AxesThatCancelAreAnError) {
  const auto rig = rig_of(with_right_at({100.0, 0.0, 0.0}, about_y(std::numbers::pi)));
  ASSERT_FALSE(rig.has_value());
  EXPECT_EQ(rig.error().code, ErrorCode::kDegenerate);
}

TEST(RigTest, AxesAlongTheBaselineAreAnError) {
  const auto rig = rig_of(with_right_at({0.0, 0.0, 100.0}, Matrix3::Identity()));
  ASSERT_FALSE(rig.has_value());
  EXPECT_EQ(rig.error().code, ErrorCode::kDegenerate);
}

TEST(RigTest, AxesAlmostAlongTheBaselineStillMakeARig) {
  // 2 sin(angle to the baseline) is what is left of the sum; the border stands at 1e-3.
  const auto at_angle = [](double angle) {
    return rig_of(with_right_at({100.0 * std::sin(angle), 0.0, 100.0 * std::cos(angle)}, Matrix3::Identity()));
  };
  EXPECT_TRUE(at_angle(0.51e-3).has_value());
  EXPECT_FALSE(at_angle(0.49e-3).has_value());
}

TEST(RigTest, ACalibrationThatIsNoNumberIsAnError) {
  StereoCalibration calibration = general_calibration();
  calibration.right_from_left.translation().x() = std::nan("");
  EXPECT_FALSE(rig_of(calibration).has_value());
}

TEST(RigTest, ParametersStandInTheDocumentedOrder) {
  const RigParameters p = parameters_of(general_calibration());
  RigParameters expected;
  expected << 628.0, 628.6, 322.3, 237.8, -0.3, 0.1, 5e-4, -3e-4, 0.0,  //
      626.1, 626.7, 317.1, 243.5, -0.28, 0.09, -4e-4, 6e-4, 0.0,        //
      0.006981317007977318, 0.17453292519943295, 0.012217304763960306, -99.6, 0.2, 8.7;
  EXPECT_NEAR((p - expected).norm(), 0.0, 1e-13);
}

TEST(RigTest, ParametersMakeTheCalibrationTheyCameFrom) {
  const StereoCalibration before = general_calibration();
  const StereoCalibration after = calibration_of(parameters_of(before), {{640, 480}, {320, 240}});
  EXPECT_EQ(after.cameras.left.focal_px, before.cameras.left.focal_px);
  EXPECT_EQ(after.cameras.right.distortion, before.cameras.right.distortion);
  EXPECT_EQ(after.cameras.right.size, (ImageSize{320, 240}));
  EXPECT_NEAR((after.right_from_left.matrix() - before.right_from_left.matrix()).norm(), 0.0, 1e-14);
}

TEST(RigTest, NoRotationHasTheParametersZero) {
  const StereoCalibration calibration = parallel_calibration(600.0, 100.0);
  EXPECT_EQ(parameters_of(calibration).segment<3>(18).norm(), 0.0);
  const StereoCalibration after = calibration_of(parameters_of(calibration), {});
  EXPECT_EQ(after.right_from_left.matrix(), calibration.right_from_left.matrix());
}

TEST(RigTest, TheBaselineIsTheLengthOfTheTranslation) {
  EXPECT_NEAR(baseline_mm(general_rig()), general_calibration().right_from_left.translation().norm(), kRoundingMm);
}

TEST(RigTest, TheEssentialMatrixIsZeroForMatchingDirections) {
  const StereoCalibration calibration = general_calibration();
  const Matrix3 essential = essential_matrix(general_rig());
  for (const auto& point : testing::vectors("E_general_model", "points")) {
    const Vec3 in_left = testing::vec3(point.at("X_left_mm"));
    const Vec3 in_right = calibration.right_from_left * in_left;
    // Products of about 100 mm times numbers of one: rounding 1e-13.
    EXPECT_NEAR((in_left / in_left.z()).dot(essential * in_right / in_right.z()), 0.0, 1e-12);
  }
}

TEST(RigTest, TheEssentialMatrixIsNotZeroForDirectionsThatDoNotMatch) {
  // Parallel axes: left' E right = B (y_right - y_left), by hand.
  const Matrix3 essential = essential_matrix(parallel_rig(600.0, 100.0));
  EXPECT_NEAR((Vec3{0.1, 0.2, 1.0}.dot(essential * Vec3{-0.1, 0.25, 1.0})), 100.0 * (0.25 - 0.2), kRoundingMm);
}

}  // namespace
}  // namespace tripoint
