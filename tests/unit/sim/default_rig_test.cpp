#include "sim/default_rig.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/camera_model.h"
#include "sim/trajectory.h"

namespace tripoint {
namespace {

RawPixel seen(const StereoCalibration& calibration, Side side, const Vec3& in_reference_mm) {
  const Result<Rig> rig = rig_of(calibration);
  EXPECT_TRUE(rig);
  const Result<RawPixel> at = projected(rig->cameras[side], rig->camera_from_rig[side] * in_reference_mm);
  EXPECT_TRUE(at);
  return *at;
}

TEST(DefaultRigTest, BaselineIsOneHundredMillimetres) {
  // |(-99.6, 0.2, 8.7)|
  EXPECT_NEAR(baseline_mm(*rig_of(default_rig())), 99.9795, 1e-4);
}

TEST(DefaultRigTest, HalfSizeSeesTheSamePlaceAtHalfThePixel) {
  const Vec3 place_mm(30.0, -40.0, 420.0);
  for (const Side side : kBothSides) {
    const RawPixel full = seen(default_rig(), side, place_mm);
    const RawPixel half = seen(default_rig({.width_px = 320, .height_px = 240}), side, place_mm);
    EXPECT_NEAR(half.u_px + 0.5, (full.u_px + 0.5) / 2.0, 1e-9);
    EXPECT_NEAR(half.v_px + 0.5, (full.v_px + 0.5) / 2.0, 1e-9);
  }
}

TEST(DefaultRigTest, WideSizeIsCutAboveAndBelow) {
  const Vec3 place_mm(30.0, -40.0, 420.0);
  const RawPixel full = seen(default_rig(), Side::kLeft, place_mm);
  const RawPixel wide = seen(default_rig({.width_px = 1280, .height_px = 720}), Side::kLeft, place_mm);
  EXPECT_NEAR(wide.u_px + 0.5, 2.0 * (full.u_px + 0.5), 1e-9);
  EXPECT_NEAR(wide.v_px + 0.5 + 120.0, 2.0 * (full.v_px + 0.5), 1e-9);
}

TEST(DefaultRigTest, BothCamerasSeeAllScenarios) {
  constexpr double kMargin_px = 12.0;  // six sigma of a spot
  for (const Trajectory& trajectory : {paper_linear(), paper_circular(), scout(), static_volume()}) {
    for (int i = 0; i < 500; ++i) {
      const Vec3 place_mm = target_pose_at(trajectory, trajectory.period * i / 500).translation();
      for (const Side side : kBothSides) {
        const RawPixel at = seen(default_rig(), side, place_mm);
        EXPECT_GT(std::min(at.u_px, at.v_px), kMargin_px) << place_mm.transpose();
        EXPECT_LT(at.u_px, 639.0 - kMargin_px) << place_mm.transpose();
        EXPECT_LT(at.v_px, 479.0 - kMargin_px) << place_mm.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace tripoint
