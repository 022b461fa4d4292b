#include "serve/pose_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "geometry/rigid_fit.h"
#include "places.h"

namespace tripoint {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Matrix3 turned(double a, double b, double c) {
  return (Eigen::AngleAxisd(a, Vec3::UnitZ()) * Eigen::AngleAxisd(b, Vec3::UnitY()) *
          Eigen::AngleAxisd(c, Vec3::UnitX()))
      .toRotationMatrix();
}

nlohmann::json vectors(const std::string& name) {
  std::ifstream file(test::top_folder() / "tests/vectors/paper_equations.json");
  return nlohmann::json::parse(file).at(name);
}

Vec3 vec3(const nlohmann::json& numbers) {
  const auto [x, y, z] = numbers.get<std::array<double, 3>>();
  return {x, y, z};
}

void expect_same_angles(const Vec3& found_rad, const Vec3& expected_deg, double tolerance_rad) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::remainder(found_rad[i] - expected_deg[i] * kDegree, 2.0 * std::numbers::pi), 0.0, tolerance_rad)
        << "of " << expected_deg.transpose() << " deg, angle " << i;
  }
}

TEST(OrientationTest, AgreesWithThePublishedVectors) {
  const auto turns = vectors("D_roll_pitch_yaw");
  ASSERT_EQ(turns.size(), 6U);
  for (const auto& vector : turns) {
    Matrix3 rotation;
    for (int row = 0; row < 3; ++row) rotation.row(row) = vec3(vector["R"][static_cast<std::size_t>(row)]);
    const auto found = orientation_of(rotation, Matrix3::Zero());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->gimbal_lock, vector["gimbal_lock"].get<bool>());
    // At B = 89.999999 deg the horizontal part of x is 1.7e-8, known to 1e-16 / 1.7e-8 = 6e-9 rad.
    const Vec3 angles_deg = vec3(vector["phi_theta_psi_deg"]);
    expect_same_angles(found->abc_rad, angles_deg, 2e-8);
    const Vec3 angles_rad = angles_deg * kDegree;
    EXPECT_LT((turned(angles_rad[0], angles_rad[1], angles_rad[2]) - rotation).norm(), 1e-14) << "Rz(A) Ry(B) Rx(C)";
  }
}

TEST(OrientationTest, OfThreePointsAgreesWithThePublishedVectors) {
  const auto frames = vectors("C_three_point_frame");
  ASSERT_EQ(frames.size(), 5U);
  for (const auto& vector : frames) {
    const Isometry3 frame = three_point_frame(vec3(vector["P1_mm"]), vec3(vector["P2_mm"]), vec3(vector["P3_mm"]));
    const auto found = orientation_of(frame.linear(), Matrix3::Zero());
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->gimbal_lock);
    expect_same_angles(found->abc_rad, vec3(vector["roll_pitch_yaw_phi_theta_psi_deg"]), 1e-14);
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
