// The orientation in the three number formats, for a rotation whose numbers are known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "serve/image.h"
#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

constexpr double kDegree = std::numbers::pi / 180.0;

/// 90 deg about Z: A = 90, B = C = 0; quaternion (sqrt 1/2, 0, 0, sqrt 1/2); rotation vector (0, 0, pi / 2).
Measurement quarter_turn() {
  Measurement measurement = position_measurement();
  measurement.pose->output_from_target = (Matrix3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
  measurement.pose->noise.diagonal().tail<3>() = Vec3(1.0, 4.0, 9.0) * std::pow(0.01 * kDegree, 2);
  return measurement;
}

RegisterImage image_of(const Measurement& measurement) {
  return image_at(edition_of(unit_state(measurement)), ServiceState{}, kExposed);
}

TEST(OrientationBlocksTest, IntegersAreMicrodegreesAndBillionths) {
  const RegisterImage image = image_of(quarter_turn());
  EXPECT_EQ(image[101] & 0x021C, 0x000C);
  EXPECT_EQ(i32_at(image, 116), 90'000'000);
  EXPECT_EQ(i32_at(image, 118), 0);
  EXPECT_EQ(i32_at(image, 120), 0);
  EXPECT_EQ(i32_at(image, 122), 707'106'781);
  EXPECT_EQ(i32_at(image, 128), 707'106'781);
  // A turns about Z of the output (0.03 deg), B about its -x (0.01), C about its y (0.02); k = 2.
  EXPECT_EQ(u32_at(image, 136), 60'000U);
  EXPECT_EQ(u32_at(image, 138), 20'000U);
  EXPECT_EQ(u32_at(image, 140), 40'000U);
}

TEST(OrientationBlocksTest, FloatsAreDegrees) {
  const RegisterImage image = image_of(quarter_turn());
  EXPECT_FLOAT_EQ(f32_at(image, 216), 90.0F);
  EXPECT_FLOAT_EQ(f32_at(image, 222), 0.70710678F);
  EXPECT_FLOAT_EQ(f32_at(image, 236), 0.06F);
}

TEST(OrientationBlocksTest, SingleRegistersCarryARotationVector) {
  const RegisterImage image = image_of(quarter_turn());
  EXPECT_EQ(i16_at(image, 307), 0);
  EXPECT_EQ(i16_at(image, 308), 0);
  EXPECT_EQ(i16_at(image, 309), 15708);
}

TEST(OrientationBlocksTest, HalfATurnFitsARegister) {
  Measurement measurement = quarter_turn();
  measurement.pose->output_from_target = (Matrix3() << 1, 0, 0, 0, -1, 0, 0, 0, -1).finished();
  EXPECT_EQ(std::abs(i16_at(image_of(measurement), 307)), 31416);
}

TEST(OrientationBlocksTest, GimbalLockIsFlaggedAndItsUncertaintiesUnknown) {
  Measurement measurement = quarter_turn();
  measurement.pose->output_from_target = (Matrix3() << 0, 0, 1, 0, 1, 0, -1, 0, 0).finished();
  const RegisterImage image = image_of(measurement);
  EXPECT_EQ(image[101] & 0x0808, 0x0808);
  EXPECT_EQ(i32_at(image, 118), 90'000'000);
  EXPECT_EQ(u32_at(image, 136), 0xFFFFFFFFU);
  EXPECT_TRUE(std::isnan(f32_at(image, 236)));
  EXPECT_NE(u32_at(image, 138), 0xFFFFFFFFU);
}

TEST(OrientationBlocksTest, AnOrientationThatIsNotFiniteLeavesThePosition) {
  Measurement measurement = quarter_turn();
  (*measurement.pose->output_from_target)(0, 0) = std::nan("");
  const RegisterImage image = image_of(measurement);
  EXPECT_EQ(image[101] & 0x000C, 0x0004);
  EXPECT_EQ(i32_at(image, 110), -18'670);
  EXPECT_EQ(u32_at(image, 122), 0x80000000U);
}

}  // namespace
}  // namespace tripoint
