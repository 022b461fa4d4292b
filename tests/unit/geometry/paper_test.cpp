#include "geometry/paper.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "vectors.h"

namespace tripoint {
namespace {

using testing::general_rig;
using testing::number;
using testing::parallel_rig;
using testing::seen_exactly;
using testing::vec2;
using testing::vec3;
using testing::vectors;

constexpr double kVectorMm = 1e-9;  // A and B agree with a general DLT to 5e-13 relative; values up to 1028 mm

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

PaperCamera camera_of(const nlohmann::json& a, const std::string& number) {
  const auto value = [&](const std::string& name, const std::string& unit) {
    return a.at(name + number + unit).get<double>();
  };
  const Vec3 offset{value("X0", "_mm"), value("Y0", "_mm"), value("Z0", "_mm")};
  return {value("F", "_mm"), radians(value("beta", "_deg")), offset, {value("u", "_mm"), value("v", "_mm")}};
}

PerSide<PaperCamera> cameras_of(const nlohmann::json& a) { return {camera_of(a, "1"), camera_of(a, "2")}; }

ParallelPair parallel_pair(const nlohmann::json& b) {
  return {number(b["F"]), number(b["B_mm"]), {vec2(b["u1"], b["v1"]), vec2(b["u2"], b["v1"])}};
}

TEST(PaperTest, Equation7GivesThePublishedPoints) {
  for (const auto& a : vectors("A_converging_axes")) {
    EXPECT_NEAR((point_by_equation_7(cameras_of(a)).value() - vec3(a["XYZ_mm"])).norm(), 0.0, kVectorMm);
  }
}

TEST(PaperTest, Equation10GivesThePublishedPoints) {
  for (const auto& b : vectors("B_parallel_axes")) {
    const Vec3 point = point_by_equation_10(parallel_pair(b)).value();
    EXPECT_NEAR((point - vec3(b["XYZ"])).norm(), 0.0, kVectorMm);
  }
}

TEST(PaperTest, Equation7WithoutAnglesIsEquation10) {
  for (const auto& b : vectors("B_parallel_axes")) {
    const ParallelPair pair = parallel_pair(b);
    const Vec3 offset{0.5 * pair.baseline, 0.0, 0.0};
    const Vec3 point =
        point_by_equation_7({{pair.focal, 0.0, offset, pair.image.left}, {pair.focal, 0.0, offset, pair.image.right}})
            .value();
    EXPECT_NEAR((point - vec3(b["XYZ"])).norm(), 0.0, kVectorMm);
  }
}

TEST(PaperTest, Equation7RefusesRaysThatDoNotMeet) {
  // Left ray along z, right ray turned by the angle: the border stands where it says.
  const auto turned = [](double angle) {
    const Vec3 offset{50.0, 0.0, 0.0};
    return PerSide<PaperCamera>{{1.0, 0.0, offset, {0.0, 0.0}}, {1.0, angle, offset, {0.0, 0.0}}};
  };
  EXPECT_EQ(point_by_equation_7(turned(0.0)).error().code, ErrorCode::kRaysAlmostParallel);
  EXPECT_EQ(point_by_equation_7(turned(0.00999), 0.01).error().code, ErrorCode::kRaysAlmostParallel);
  EXPECT_TRUE(point_by_equation_7(turned(0.01001), 0.01).has_value());
}

TEST(PaperTest, Equation7RefusesALeftRayAcrossZ) {
  const Vec3 offset{50.0, 0.0, 0.0};
  const double angle = radians(45.0);
  const auto point = point_by_equation_7({{1.0, angle, offset, {-1.0, 0.0}}, {1.0, 0.0, offset, {0.0, 0.0}}});
  ASSERT_FALSE(point.has_value());
  EXPECT_EQ(point.error().code, ErrorCode::kDegenerate);
}

TEST(PaperTest, Equation10RefusesEqualColumns) {
  const auto point = point_by_equation_10({4.6, 100.0, {{0.3, 0.1}, {0.3, 0.1}}});
  ASSERT_FALSE(point.has_value());
  EXPECT_EQ(point.error().code, ErrorCode::kRaysAlmostParallel);
}

/// A case of vectors A as a rig in the paper's common frame, and its pixels at 5 um each.
struct PaperCase {
  Rig rig;
  PerSide<MeasuredPixel> seen;
};
PaperCase pixels_of(const nlohmann::json& a) {
  constexpr double kPixelMm = 0.005;
  const PerSide<PaperCamera> cameras = cameras_of(a);
  PaperCase result;
  for (const Side side : kBothSides) {
    const PaperCamera& camera = cameras[side];
    const double sign = side == Side::kLeft ? 1.0 : -1.0;
    const double focal_px = camera.focal / kPixelMm;
    Isometry3 rig_from_camera = Isometry3::Identity();  // Eq. 1 and 5, corrected, at the lens centre (0, 0, F)
    rig_from_camera.linear() = Eigen::AngleAxisd{sign * camera.angle_rad, Vec3::UnitY()}.toRotationMatrix();
    rig_from_camera.translation() = rig_from_camera.linear() * Vec3{0.0, 0.0, camera.focal} -
                                    Vec3{sign * camera.offset.x(), camera.offset.y(), camera.offset.z()};
    result.rig.cameras[side] = {{640, 480}, {focal_px, focal_px}, {320.0, 240.0}, {}};
    result.rig.camera_from_rig[side] = rig_from_camera.inverse();
    result.seen[side].at = {320.0 - camera.image.x() / kPixelMm, 240.0 - camera.image.y() / kPixelMm};
  }
  return result;
}

TEST(PaperTest, InUprightPixelsThePublishedConvergingPointsComeOut) {
  for (const auto& a : vectors("A_converging_axes")) {
    const PaperCase given = pixels_of(a);
    const auto point = triangulated_by_paper(given.rig, given.seen);
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR((point->in_rig_mm - vec3(a["XYZ_mm"])).norm(), 0.0, kVectorMm);
  }
}

TEST(PaperTest, ForAnyRigExactPixelsGiveThePublishedPoints) {
  const Rig rig = general_rig();
  for (const auto& e : vectors("E_general_model", "points")) {
    const auto point =
        triangulated_by_paper(rig, {{testing::pixel(e.at("left_px"))}, {testing::pixel(e.at("right_px"))}});
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR((rig.camera_from_rig.left * point->in_rig_mm - vec3(e.at("X_left_mm"))).norm(), 0.0, kVectorMm);
    EXPECT_NEAR(point->chi2, 0.0, 1e-18);
  }
}

TEST(PaperTest, ForParallelAxesExactPixelsGiveThePoint) {
  const Rig rig = parallel_rig(600.0, 100.0);
  for (const Vec3& truth : {Vec3{0.0, 0.0, 400.0}, Vec3{-80.0, 60.0, 350.0}, Vec3{70.0, -40.0, 500.0}}) {
    const auto point = triangulated_by_paper(rig, seen_exactly(rig, truth));
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR((point->in_rig_mm - truth).norm(), 0.0, kVectorMm);
  }
}

TEST(PaperTest, TheHeightComesFromTheLeftCameraAlone) {
  const Rig rig = general_rig();
  auto seen = seen_exactly(rig, {20.0, 10.0, 400.0});
  seen.right.at.v_px += 1.0;
  const TriangulatedPoint point = triangulated_by_paper(rig, seen).value();
  EXPECT_NEAR(point.residual_px.left.norm(), 0.0, 1e-10);
  // The whole pixel stays in the right picture, less what 10 degrees of convergence turn into the column.
  EXPECT_NEAR(point.residual_px.right.norm(), 1.0, 0.02);
}

TEST(PaperTest, ItsResidualIsTheEpipolarOne) {
  const Rig rig = general_rig();
  auto seen = seen_exactly(rig, {20.0, 10.0, 400.0}, 0.2);
  seen.right.at.v_px += 1.0;
  // First order against exact: 1 px over a focal length of 628 px.
  const double exact = triangulated(rig, seen)->chi2;
  EXPECT_NEAR(triangulated_by_paper(rig, seen)->chi2, exact, 4e-3 * exact);
}

TEST(PaperTest, ParallelRaysAreAnErrorFromTheAngleGiven) {
  const Rig rig = parallel_rig(600.0, 100.0);
  const double z = 50.0 / std::tan(0.5 * 0.01);
  EXPECT_TRUE(triangulated_by_paper(rig, seen_exactly(rig, {0.0, 0.0, z * (1.0 - 1e-6)})).has_value());
  EXPECT_EQ(triangulated_by_paper(rig, seen_exactly(rig, {0.0, 0.0, z * (1.0 + 1e-6)})).error().code,
            ErrorCode::kRaysAlmostParallel);
}

TEST(PaperTest, DivergingRaysAreAPointBehindTheCameras) {
  const Rig rig = parallel_rig(600.0, 100.0);
  const auto point = triangulated_by_paper(rig, {{{200.0, 240.0}}, {{350.0, 240.0}}});
  ASSERT_FALSE(point.has_value());
  EXPECT_EQ(point.error().code, ErrorCode::kBehindCamera);
}

TEST(PaperTest, APixelThatCannotBeUndistortedIsAnError) {
  const auto point = triangulated_by_paper(general_rig(), {{{std::nan(""), 240.0}}, {{250.0, 240.0}}});
  ASSERT_FALSE(point.has_value());
  EXPECT_EQ(point.error().code, ErrorCode::kNoConvergence);
}

TEST(PaperTest, ARayAcrossTheTurnedAxisIsAnError) {
  // Both cameras pitched 60 degrees down against the frame: a direction 40 degrees farther down looks backwards.
  Rig rig = parallel_rig(600.0, 100.0);
  const Matrix3 pitch = Eigen::AngleAxisd{radians(60.0), Vec3::UnitX()}.toRotationMatrix();
  for (const Side side : kBothSides) rig.camera_from_rig[side].prerotate(pitch);
  const double v_px = 240.0 + 600.0 * std::tan(radians(40.0));
  const auto point = triangulated_by_paper(rig, {{{400.0, v_px}}, {{250.0, v_px}}});
  ASSERT_FALSE(point.has_value());
  EXPECT_EQ(point.error().code, ErrorCode::kDegenerate);
}

}  // namespace
}  // namespace tripoint
