#include "serve/pose_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "places.h"

namespace tripoint {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Matrix3 turned(double a, double b, double c) {
  return (Eigen::AngleAxisd(a, Vec3::UnitZ()) * Eigen::AngleAxisd(b, Vec3::UnitY()) *
          Eigen::AngleAxisd(c, Vec3::UnitX()))
      .toRotationMatrix();
}

TEST(OrientationTest, AgreesWithThePublishedVectors) {
  std::ifstream file(test::top_folder() / "tests/vectors/paper_equations.json");
  ASSERT_TRUE(file.is_open());
  const auto vectors = nlohmann::json::parse(file)["D_roll_pitch_yaw"];
  ASSERT_GE(vectors.size(), 6U);
  for (const auto& vector : vectors) {
    Matrix3 rotation;
    const auto rows = vector["R"].get<std::array<std::array<double, 3>, 3>>();
    for (std::size_t i = 0; i < 9; ++i) rotation(static_cast<int>(i / 3), static_cast<int>(i % 3)) = rows[i / 3][i % 3];
    const auto found = orientation_of(rotation, Matrix3::Zero());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->gimbal_lock, vector["gimbal_lock"].get<bool>());
    // At B = 89.999999 deg the horizontal part of x is 1.7e-8, known to 1e-16 / 1.7e-8 = 6e-9 rad.
    const auto expected_deg = vector["phi_theta_psi_deg"].get<std::array<double, 3>>();
    for (int i = 0; i < 3; ++i) {
      const double expected = expected_deg[static_cast<std::size_t>(i)] * kDegree;
      EXPECT_NEAR(std::remainder(found->abc_rad[i] - expected, 2.0 * std::numbers::pi), 0.0, 2e-8) << vector["R"];
    }
  }
}

TEST(OrientationTest, QuaternionAndRotationVectorTurnTheSameWay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (int i = 0; i < 200; ++i) {
    const Matrix3 rotation = turned(angle(random), angle(random) / 2.0, angle(random));
    const auto found = orientation_of(rotation, Matrix3::Zero());
    ASSERT_TRUE(found);
    const Eigen::Vector4d& q = found->quaternion_wxyz;
    EXPECT_GE(q[0], 0.0);
    EXPECT_LT((Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix() - rotation).norm(), 1e-12);
    const Vec3& vector = found->rotation_vector_rad;
    EXPECT_LT((Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix() - rotation).norm(), 1e-12);
    EXPECT_LE(vector.norm(), std::numbers::pi + 1e-12);
  }
}

TEST(OrientationTest, NoRotationIsAZeroVector) {
  const auto found = orientation_of(Matrix3::Identity(), Matrix3::Zero());
  EXPECT_EQ(found->rotation_vector_rad, Vec3::Zero());
  EXPECT_EQ(found->quaternion_wxyz, Eigen::Vector4d(1.0, 0.0, 0.0, 0.0));
}

TEST(OrientationTest, AngleUncertaintyAgreesWithASampledRotation) {
  const Matrix3 rotation = turned(0.7, -1.1, 2.0);
  Matrix3 root;
  root << 1.0, 0.2, -0.1, 0.0, 0.7, 0.3, 0.0, 0.0, 1.3;
  root *= 1e-4;
  const auto found = orientation_of(rotation, root * root.transpose());
  ASSERT_TRUE(found && found->expanded_a_rad && found->expanded_c_rad);
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  constexpr int kSamples = 20000;
  Vec3 sum_of_squares = Vec3::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 w = root * Vec3(normal(random), normal(random), normal(random));
    const Matrix3 moved = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix() * rotation;
    sum_of_squares += (orientation_of(moved, Matrix3::Zero())->abc_rad - found->abc_rad).cwiseAbs2();
  }
  const Vec3 expanded = 2.0 * (sum_of_squares / kSamples).cwiseSqrt();
  // A standard deviation from n samples is known to 1 / sqrt(2 n) = 0.5 %: five of those.
  EXPECT_NEAR(*found->expanded_a_rad / expanded[0], 1.0, 0.025);
  EXPECT_NEAR(found->expanded_b_rad / expanded[1], 1.0, 0.025);
  EXPECT_NEAR(*found->expanded_c_rad / expanded[2], 1.0, 0.025);
}

TEST(OrientationTest, InGimbalLockTwoUncertaintiesAreUnknown) {
  Matrix3 rotation;
  rotation << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  const auto found = orientation_of(rotation, Matrix3::Identity() * 1e-8);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->gimbal_lock);
  EXPECT_FALSE(found->expanded_a_rad);
  EXPECT_FALSE(found->expanded_c_rad);
  EXPECT_NEAR(found->expanded_b_rad, 2e-4, 1e-12);
}

TEST(OrientationTest, ANumberThatIsNotFiniteIsRefused) {
  Matrix3 rotation = Matrix3::Identity();
  rotation(1, 1) = std::nan("");
  EXPECT_FALSE(orientation_of(rotation, Matrix3::Zero()));
  EXPECT_FALSE(orientation_of(Matrix3::Identity(), -Matrix3::Identity()));
}

TEST(PoseNumbersTest, NoiseAndCalibrationCountTogether) {
  TargetPose pose;
  pose.noise.diagonal() << 0.09, 0.0, 0.0, 0.0, 0.0, 0.0;
  pose.shared.diagonal() << 0.16, 0.0, 0.0, 0.0, 0.0, 0.0;
  EXPECT_NEAR(numbers_of(pose)->expanded_mm.x(), 1.0, 1e-12);  // 2 sqrt(0.3^2 + 0.4^2)
}

TEST(PoseNumbersTest, APositionThatNoRegisterHoldsIsRefused) {
  TargetPose pose;
  pose.position_in_output_mm.x() = 2e6;
  EXPECT_TRUE(numbers_of(pose));
  pose.position_in_output_mm.x() = 2.0001e6;
  EXPECT_FALSE(numbers_of(pose));
}

TEST(PoseNumbersTest, ANegativeVarianceIsRefused) {
  TargetPose pose;
  pose.noise(1, 1) = -1e-9;
  EXPECT_FALSE(numbers_of(pose));
}

}  // namespace
}  // namespace tripoint
