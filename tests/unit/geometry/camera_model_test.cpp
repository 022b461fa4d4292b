#include "geometry/camera_model.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_calibration;
using testing::pixel;
using testing::vec3;
using testing::vectors;

// The vectors carry 17 digits of numbers up to 480, so 5e-14 px; some 30 roundings of our own stay below 1e-11.
constexpr double kVectorPx = 1e-11;

CameraModel with_distortion(const std::array<double, 5>& distortion) {
  return {{640, 480}, {600.0, 500.0}, {320.0, 240.0}, distortion};
}

TEST(CameraModelTest, ProjectionAgreesWithThePublishedVectorsInBothCameras) {
  const StereoCalibration calibration = general_calibration();
  for (const auto& point : vectors("E_general_model", "points")) {
    const Vec3 in_left = vec3(point.at("X_left_mm"));
    const RawPixel left = projected(calibration.cameras.left, in_left).value();
    const RawPixel right = projected(calibration.cameras.right, calibration.right_from_left * in_left).value();
    EXPECT_NEAR(left.u_px, pixel(point.at("left_px")).u_px, kVectorPx);
    EXPECT_NEAR(left.v_px, pixel(point.at("left_px")).v_px, kVectorPx);
    EXPECT_NEAR(right.u_px, pixel(point.at("right_px")).u_px, kVectorPx);
    EXPECT_NEAR(right.v_px, pixel(point.at("right_px")).v_px, kVectorPx);
  }
}

TEST(CameraModelTest, UndistortionAgreesWithThePublishedVectors) {
  const StereoCalibration calibration = general_calibration();
  for (const auto& point : vectors("E_general_model", "points")) {
    const Vec3 in_left = vec3(point.at("X_left_mm"));
    const NormalizedPoint at = undistorted(calibration.cameras.left, pixel(point.at("left_px"))).value();
    EXPECT_NEAR(at.x, in_left.x() / in_left.z(), 1e-12);
    EXPECT_NEAR(at.y, in_left.y() / in_left.z(), 1e-12);
  }
}

TEST(CameraModelTest, RadialDistortionIsBrownsPolynomial) {
  // r = 0.5: 1 - 0.3 * 0.25 + 0.1 * 0.0625 - 0.02 * 0.015625 = 0.9309375
  const RawPixel at = distorted(with_distortion({-0.3, 0.1, 0.0, 0.0, -0.02}), {0.3, 0.4});
  EXPECT_NEAR(at.u_px, 320.0 + 600.0 * 0.3 * 0.9309375, 1e-12 * 640);
  EXPECT_NEAR(at.v_px, 240.0 + 500.0 * 0.4 * 0.9309375, 1e-12 * 640);
}

TEST(CameraModelTest, TangentialDistortionFollowsOpenCvsOrderOfCoefficients) {
  // x = 0.1, y = 0.2: x + 2 p1 x y + p2 (r2 + 2 x^2), y + p1 (r2 + 2 y^2) + 2 p2 x y with p1 = 0.01, p2 = 0.02
  const RawPixel at = distorted(with_distortion({0.0, 0.0, 0.01, 0.02, 0.0}), {0.1, 0.2});
  EXPECT_NEAR(at.u_px, 320.0 + 600.0 * (0.1 + 0.0004 + 0.0014), 1e-12 * 640);
  EXPECT_NEAR(at.v_px, 240.0 + 500.0 * (0.2 + 0.0013 + 0.0008), 1e-12 * 640);
}

TEST(CameraModelTest, UndistortionInvertsTheModelOverTheWholePicture) {
  // Condition: the smallest stretch in these pictures is above 0.5, so residuals of 1e-15 become below 1e-14.
  const StereoCalibration calibration = general_calibration();
  for (double y = -0.45; y <= 0.45; y += 0.05) {
    for (double x = -0.6; x <= 0.6; x += 0.05) {
      const RawPixel raw = distorted(calibration.cameras.right, {x, y});
      const NormalizedPoint back = undistorted(calibration.cameras.right, raw).value();
      EXPECT_NEAR(back.x, x, 1e-12);
      EXPECT_NEAR(back.y, y, 1e-12);
    }
  }
}

TEST(CameraModelTest, JacobianOfTheDistortionIsTheSlopeOfTheModel) {
  const CameraModel camera = with_distortion({-0.3, 0.1, 0.003, -0.002, -0.02});
  const NormalizedPoint at{0.31, -0.42};
  constexpr double kStep = 1e-5;  // error: step^2 * third derivative (~1e3 px) = 1e-7, rounding 1e-13 / 1e-5 = 1e-8
  const Matrix2 jacobian = distortion_jacobian_px(camera, at);
  for (int column = 0; column < 2; ++column) {
    const double dx = column == 0 ? kStep : 0.0;
    const double dy = column == 1 ? kStep : 0.0;
    const RawPixel above = distorted(camera, {at.x + dx, at.y + dy});
    const RawPixel below = distorted(camera, {at.x - dx, at.y - dy});
    EXPECT_NEAR(jacobian(0, column), (above.u_px - below.u_px) / (2.0 * kStep), 1e-6);
    EXPECT_NEAR(jacobian(1, column), (above.v_px - below.v_px) / (2.0 * kStep), 1e-6);
  }
}

TEST(CameraModelTest, JacobianOfTheProjectionIsItsSlopeInSpace) {
  const CameraModel camera = general_calibration().cameras.left;
  const Vec3 point{60.0, -45.0, 380.0};
  constexpr double kStepMm = 1e-2;  // error: step^2 * (1e-5 px/mm^3) = 1e-9, rounding 1e-13 / 1e-2 = 1e-11
  const Matrix23 jacobian = projection_jacobian_px_per_mm(camera, point);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = kStepMm * Vec3::Unit(axis);
    const RawPixel above = projected(camera, point + step).value();
    const RawPixel below = projected(camera, point - step).value();
    EXPECT_NEAR(jacobian(0, axis), (above.u_px - below.u_px) / (2.0 * kStepMm), 1e-8);
    EXPECT_NEAR(jacobian(1, axis), (above.v_px - below.v_px) / (2.0 * kStepMm), 1e-8);
  }
}

// k1 = -0.3 alone: the radius in the picture, r - 0.3 r^3, is largest (0.70273) at r = 1/sqrt(0.9) = 1.05409.
TEST(CameraModelTest, APixelBeyondTheFoldOfTheDistortionIsAnError) {
  const CameraModel camera = with_distortion({-0.3, 0.0, 0.0, 0.0, 0.0});
  const auto outside = undistorted(camera, {320.0 + 600.0 * 0.7028, 240.0});
  ASSERT_FALSE(outside.has_value());
  EXPECT_EQ(outside.error().code, ErrorCode::kNoConvergence);
}

TEST(CameraModelTest, NoPixelFarBeyondTheFoldIsTakenForTheMirrorImageOfADirection) {
  // r - 0.3 r^3 reaches every radius again at negative r, on the far side of the centre.
  const CameraModel camera = with_distortion({-0.3, 0.0, 0.0, 0.0, 0.0});
  for (double radius = 0.71; radius < 20.0; radius *= 1.05) {
    EXPECT_FALSE(undistorted(camera, {320.0 + 600.0 * radius, 240.0}).has_value()) << radius;
  }
}

TEST(CameraModelTest, APixelJustInsideTheFoldHasItsDirection) {
  const CameraModel camera = with_distortion({-0.3, 0.0, 0.0, 0.0, 0.0});
  const auto inside = undistorted(camera, distorted(camera, {1.045, 0.0}));
  ASSERT_TRUE(inside.has_value());
  EXPECT_NEAR(inside->x, 1.045, 1e-12 / 0.017);  // the stretch there: 1 - 0.9 * 1.045^2 = 0.0172
}

TEST(CameraModelTest, ADirectionOnlyBeyondTwoFoldsIsAnError) {
  // k1 = -0.5, k2 = 0.1 folds at r = 1 and unfolds at r = sqrt 2; only r = 1.82 has the radius 0.8.
  const CameraModel camera = with_distortion({-0.5, 0.1, 0.0, 0.0, 0.0});
  const auto beyond = undistorted(camera, {320.0 + 600.0 * 0.8, 240.0});
  ASSERT_FALSE(beyond.has_value());
  EXPECT_EQ(beyond.error().code, ErrorCode::kNoConvergence);
}

TEST(CameraModelTest, APixelThatIsNoNumberIsAnError) {
  const CameraModel camera = general_calibration().cameras.left;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(undistorted(camera, {bad, 10.0}).error().code, ErrorCode::kNoConvergence);
    EXPECT_EQ(undistorted(camera, {10.0, bad}).error().code, ErrorCode::kNoConvergence);
  }
}

TEST(CameraModelTest, APointBehindOrInTheLensPlaneIsAnError) {
  const CameraModel camera = general_calibration().cameras.left;
  for (const double z : {-400.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto behind = projected(camera, {1.0, 2.0, z});
    ASSERT_FALSE(behind.has_value());
    EXPECT_EQ(behind.error().code, ErrorCode::kBehindCamera);
  }
}

TEST(CameraModelTest, APointBarelyInFrontHasAPixel) {
  EXPECT_TRUE(projected(general_calibration().cameras.left, {0.0, 0.0, 1e-9}).has_value());
}

}  // namespace
}  // namespace tripoint
