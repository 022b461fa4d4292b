#include "geometry/rays.h"

#include <numbers>

#include <gtest/gtest.h>

#include "vectors.h"

namespace tripoint {
namespace {

using testing::parallel_rig;

TEST(RaysTest, ARayStartsAtTheLensAndPassesThroughThePoint) {
  const Rig rig = testing::general_rig();
  const Vec3 point{30.0, -20.0, 400.0};
  const auto seen = testing::seen_exactly(rig, point);
  const PerSide<Ray> rays = rays_of(rig, {seen.left.at, seen.right.at}).value();
  for (const Side side : kBothSides) {
    const Vec3 to_point = point - rays[side].center_in_rig_mm;
    EXPECT_NEAR(rays[side].direction_in_rig.norm(), 1.0, 1e-15);
    EXPECT_NEAR((rays[side].direction_in_rig.cross(to_point)).norm(), 0.0, 1e-10);  // 400 mm times 1e-13
    EXPECT_GT(rays[side].direction_in_rig.dot(to_point), 0.0);
  }
}

TEST(RaysTest, APixelOutsideTheDomainOfEitherCameraIsAnError) {
  const Rig rig = testing::general_rig();
  const RawPixel good{320.0, 240.0};
  const RawPixel bad{std::nan(""), 0.0};
  EXPECT_EQ(rays_of(rig, {bad, good}).error().code, ErrorCode::kNoConvergence);
  EXPECT_EQ(rays_of(rig, {good, bad}).error().code, ErrorCode::kNoConvergence);
}

TEST(RaysTest, TheAngleIsExactFromZeroToPi) {
  for (const double angle : {0.0, 1e-9, 0.5, std::numbers::pi}) {
    const PerSide<Ray> rays{{{}, Vec3::Zero(), Vec3::UnitZ()},
                            {{}, Vec3::Zero(), {std::sin(angle), 0, std::cos(angle)}}};
    EXPECT_NEAR(angle_between_rad(rays), angle, 1e-15);
  }
}

TEST(RaysTest, TheMidpointHalvesTheShortestSegmentBetweenSkewLines) {
  // Along z through (-1, 0, 0) + along x through (5, 4, 10): nearest at (-1, 0, 10) and (-1, 4, 10).
  const PerSide<Ray> rays{{{}, {-1.0, 0.0, 0.0}, Vec3::UnitZ()}, {{}, {5.0, 4.0, 10.0}, -Vec3::UnitX()}};
  EXPECT_NEAR((midpoint_in_rig_mm(rays) - Vec3{-1.0, 2.0, 10.0}).norm(), 0.0, 1e-14);
}

TEST(RaysTest, APointIsInFrontOnlyWhenBothCamerasHaveItInFront) {
  Rig rig = parallel_rig(600.0, 100.0);
  EXPECT_TRUE(in_front_of_both(rig, {0.0, 0.0, 1e-9}));
  EXPECT_FALSE(in_front_of_both(rig, {0.0, 0.0, 0.0}));
  rig.camera_from_rig.right.translation().z() = -50.0;
  EXPECT_FALSE(in_front_of_both(rig, {0.0, 0.0, 49.0}));
  EXPECT_TRUE(in_front_of_both(rig, {0.0, 0.0, 51.0}));
}

}  // namespace
}  // namespace tripoint
