#include "geometry/rigid_fit.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"
#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_rig;
using testing::Noise;
using testing::relative_difference;
using testing::seen_exactly;
using testing::Spread;

const std::vector<Vec3> kTriangle{{-20.0, 12.0, 0.0}, {80.0, 12.0, 0.0}, {-2.0, -36.0, 0.0}};

Isometry3 pose(const Vec3& place_mm, const Vec3& turn_rad) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
  pose.translation() = place_mm;
  return pose;
}

const Isometry3 kPose = pose({30.0, -20.0, 420.0}, {2.6, 0.3, -0.4});

std::vector<BodyPoint> seen_at(const Rig& rig, const Isometry3& rig_from_body, const std::vector<Vec3>& body) {
  std::vector<BodyPoint> points;
  for (const Vec3& point : body) points.push_back({point, 0.0, seen_exactly(rig, rig_from_body * point)});
  return points;
}

PoseParameters difference(const Isometry3& from, const Isometry3& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  PoseParameters step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

TEST(ThreePointFrameTest, IsThatOfTheVectors) {
  const auto frames = testing::vectors("C_three_point_frame");
  ASSERT_EQ(frames.size(), 5U);
  for (const auto& c : frames) {
    const Vec3 p1 = testing::vec3(c["P1_mm"]);
    const Vec3 p2 = testing::vec3(c["P2_mm"]);
    const Vec3 p3 = testing::vec3(c["P3_mm"]);
    const Isometry3 frame = three_point_frame(p1, p2, p3);
    EXPECT_LT((frame.linear().col(0) - testing::vec3(c["x"])).norm(), 1e-14);
    EXPECT_LT((frame.linear().col(1) - testing::vec3(c["y"])).norm(), 1e-14);
    EXPECT_LT((frame.linear().col(2) - testing::vec3(c["z"])).norm(), 1e-14);
    // Eq. 12 as printed takes the line from P3 to the middle of the two others for z.
    const Vec3 printed = 0.5 * (p1 + p2) - p3;
    const Vec3 z = frame.linear().col(2);
    EXPECT_NEAR(std::atan2(z.cross(printed).norm(), z.dot(printed)) * 180.0 / M_PI,
                testing::number(c["printed_eq12_z_axis_error_deg"]), 1e-12);
  }
}

TEST(RigidFitTest, ExactPicturesGiveTheExactPoseFromFarAway) {
  const Rig rig = general_rig();
  const auto points = seen_at(rig, kPose, kTriangle);
  PoseParameters off;
  off << 15.0, -10.0, 40.0, 0.3, -0.2, 0.25;
  const RigidFit fit = rigid_fit(rig, points, moved(kPose, off)).value();
  EXPECT_LT(difference(kPose, fit.rig_from_body).norm(), 1e-7);
  EXPECT_LT(fit.chi2, 1e-15);
}

TEST(RigidFitTest, NoisyPixelsScatterThePoseAsItsCovarianceSays) {
  const Rig rig = general_rig();
  auto points = seen_at(rig, kPose, kTriangle);
  for (BodyPoint& point : points) {
    point.seen.left.covariance_px2 << 0.010, 0.004, 0.004, 0.005;
    point.seen.right.covariance_px2 << 0.003, -0.002, -0.002, 0.020;
  }
  Noise noise{21};
  Spread<6> spread;
  double chi2_sum = 0.0;
  constexpr int kRuns = 20'000;
  for (int run = 0; run < kRuns; ++run) {
    auto disturbed = points;
    for (BodyPoint& point : disturbed) {
      for (const Side side : kBothSides) {
        const Vec2 error = noise.vector<2>(point.seen[side].covariance_px2);
        point.seen[side].at = {point.seen[side].at.u_px + error.x(), point.seen[side].at.v_px + error.y()};
      }
    }
    const RigidFit fit = rigid_fit(rig, disturbed, kPose).value();
    spread.add(difference(kPose, fit.rig_from_body));
    chi2_sum += fit.chi2;
  }
  EXPECT_LT(relative_difference<6>(spread.covariance(), rigid_fit(rig, points, kPose)->covariance), 0.06);
  EXPECT_NEAR(chi2_sum / kRuns, 6.0, 0.15);  // 12 coordinates, 6 of them used up
}

TEST(RigidFitTest, MisplacedPointsScatterThePoseAsItsCovarianceSays) {
  const Rig rig = general_rig();
  constexpr double kSigma_mm = 0.2;
  const Matrix3 body_covariance = Matrix3::Identity() * kSigma_mm * kSigma_mm;
  Noise noise{22};
  Spread<6> spread;
  double chi2_sum = 0.0;
  constexpr int kRuns = 20'000;
  const auto with_sigma = [&](std::vector<BodyPoint> points) {
    for (BodyPoint& point : points) {
      point.sigma_mm = kSigma_mm;
      point.seen.left.covariance_px2 = point.seen.right.covariance_px2 = Matrix2::Identity() * 1e-4;
    }
    return points;
  };
  for (int run = 0; run < kRuns; ++run) {
    std::vector<Vec3> made = kTriangle;
    for (Vec3& point : made) point += noise.vector<3>(body_covariance);
    auto points = with_sigma(seen_at(rig, kPose, made));
    for (std::size_t i = 0; i < points.size(); ++i) points[i].in_body_mm = kTriangle[i];
    for (BodyPoint& point : points) {
      for (const Side side : kBothSides) {
        const Vec2 error = noise.vector<2>(point.seen[side].covariance_px2);
        point.seen[side].at = {point.seen[side].at.u_px + error.x(), point.seen[side].at.v_px + error.y()};
      }
    }
    const RigidFit fit = rigid_fit(rig, points, kPose).value();
    spread.add(difference(kPose, fit.rig_from_body));
    chi2_sum += fit.chi2;
  }
  const RigidFit stated = rigid_fit(rig, with_sigma(seen_at(rig, kPose, kTriangle)), kPose).value();
  EXPECT_LT(relative_difference<6>(spread.covariance(), stated.covariance), 0.06);
  EXPECT_NEAR(chi2_sum / kRuns, 6.0, 0.15);
}

TEST(RigidFitTest, PointsThatDoNotDetermineAPoseAreRefused) {
  const Rig rig = general_rig();
  const auto code_of = [&](const std::vector<Vec3>& body) {
    const auto fit = rigid_fit(rig, seen_at(rig, kPose, body), kPose);
    return fit ? std::optional<ErrorCode>{} : fit.error().code;
  };
  EXPECT_EQ(code_of({}), ErrorCode::kDegenerate);
  EXPECT_EQ(code_of({{0, 0, 0}, {60, 0, 0}}), ErrorCode::kDegenerate);
  EXPECT_EQ(code_of({{0, 0, 0}, {30, 0, 0}, {60, 0, 0}}), ErrorCode::kDegenerate);
  EXPECT_EQ(code_of(kTriangle), std::nullopt);
}

TEST(RigidFitTest, NoNumberOrNoCovarianceIsRefused) {
  const Rig rig = general_rig();
  auto points = seen_at(rig, kPose, kTriangle);
  points[1].seen.left.covariance_px2.setZero();
  EXPECT_EQ(rigid_fit(rig, points, kPose).error().code, ErrorCode::kDegenerate);
  points = seen_at(rig, kPose, kTriangle);
  points[2].seen.right.at.u_px = std::nan("");
  EXPECT_FALSE(rigid_fit(rig, points, kPose).has_value());
  EXPECT_EQ(rigid_fit(rig, seen_at(rig, kPose, kTriangle), pose({0, 0, -400}, {0.1, 0, 0})).error().code,
            ErrorCode::kBehindCamera);
}

}  // namespace
}  // namespace tripoint
