#include "line/match/epipolar.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"

namespace tripoint {
namespace {

using testing::webcam_model;

PerSide<RawPixel> pixels_of(const LineModel& model, const Vec3& point) {
  return {testing::pixel_of(model, Side::kLeft, testing::at_rest(point), 0.0, 0.0),
          testing::pixel_of(model, Side::kRight, testing::at_rest(point), 0.0, 0.0)};
}

PerSide<MeasuredPixel> measured(const PerSide<RawPixel>& pixels, double sigma_px) {
  const Matrix2 covariance = sigma_px * sigma_px * Matrix2::Identity();
  return {{pixels.left, covariance}, {pixels.right, covariance}};
}

TEST(EpipolarTest, TheCalibrationGradientIsThatOfTheDistance) {
  const LineModel model = webcam_model();
  for (const Vec3& point : {Vec3{10.0, 15.0, 400.0}, Vec3{-80.0, 70.0, 350.0}, Vec3{60.0, -60.0, 480.0}}) {
    const PerSide<RawPixel> pixels = pixels_of(model, point);
    const auto gradient = epipolar_calibration_gradient(model.calibration, pixels);
    ASSERT_TRUE(gradient);
    const RigParameters parameters = parameters_of(model.calibration);
    const PerSide<ImageSize> sizes{{640, 480}, {640, 480}};
    for (int i = 0; i < 24; ++i) {
      const double step = std::max(std::abs(parameters[i]), 1.0) * 1e-6;
      const auto distance = [&](double sign) {
        RigParameters changed = parameters;
        changed[i] += sign * step;
        return epipolar_error(*rig_of(calibration_of(changed, sizes)), measured(pixels, 0.05))->distance_px;
      };
      const double numeric = (distance(1.0) - distance(-1.0)) / (2.0 * step);
      // central differences: truncation about step^2, rounding 1e-13 px / step
      EXPECT_NEAR((*gradient)[i], numeric, 1e-4 * std::max(1.0, std::abs(numeric))) << "parameter " << i;
    }
  }
}

TEST(EpipolarTest, TheGateOpensAtItsSigmas) {
  LineModel model = webcam_model();
  PerSide<RawPixel> pixels = pixels_of(model, {10.0, 15.0, 400.0});
  const double sigma_px = epipolar_gate(model, measured(pixels, 0.05))->sigma_px;
  EXPECT_NEAR(sigma_px, 0.05, 1e-9) << "the distance of two equally good pixels is as good as one of them";
  const double v_px = pixels.right.v_px;
  const auto passed_at = [&](double sigmas) {
    // a shift d across the lines moves the distance by d / sqrt2
    pixels.right.v_px = v_px + sigmas * sigma_px * std::sqrt(2.0);
    return epipolar_gate(model, measured(pixels, 0.05))->passed;
  };
  EXPECT_TRUE(passed_at(4.3));
  EXPECT_FALSE(passed_at(4.7));
  EXPECT_TRUE(passed_at(-4.3));
  EXPECT_FALSE(passed_at(-4.7));
}

TEST(EpipolarTest, APixelOutsideTheLensGivesNothing) {
  LineModel model = webcam_model();
  model.calibration.cameras.left.distortion[0] = model.rig.cameras.left.distortion[0] = -1.5;
  EXPECT_FALSE(epipolar_gate(model, measured({{5000.0, 5000.0}, {320.0, 240.0}}, 0.05)));
}

}  // namespace
}  // namespace tripoint
