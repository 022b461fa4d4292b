// A flat target tilted to one side looks almost like one tilted to the other.
#include <iostream>
#include <vector>

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include "tag_views.h"

namespace tripoint {
namespace {

using testing::error_of;
using testing::kViews;
using testing::seen;
using testing::tag_model;
using testing::tilted;

// 8 mm at 590 mm are 8 px: with an edge known to 0.3 px, what tells the two tilts apart is lost in noise.
TEST(LineTiltedTagsTest, ATagWhoseTiltCannotBeToldIsAmbiguousAndNeverTheWrongWayRound) {
  const LineModel model = tag_model(1, 8.0);
  const Isometry3 truth = tilted({45.0, 10.0, 590.0}, 0.5);
  int ambiguous = 0;
  for (const Measurement& one : seen(model, {.model = {model, model}, .pose = truth, .sigma_px = 0.3})) {
    if (one.faults.contains(Fault::kAmbiguous)) ++ambiguous;
    if (!one.pose) continue;
    const Vec3 turn_rad = error_of(*one.pose, truth).tail<3>();
    const Matrix3 spread = one.pose->noise.bottomRightCorner<3, 3>();
    EXPECT_LT(turn_rad.dot(spread.ldlt().solve(turn_rad)), 36.0);
  }
  EXPECT_GT(ambiguous, kViews / 10);
}

class SmallTagTest : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Sizes, SmallTagTest, ::testing::Values(12.0, 20.0, 30.0));

// Small tags that look almost straight at the cameras: both tilts run into one fit, in a valley that is wider than a
// covariance says.
TEST_P(SmallTagTest, IsNeverTiltedByFarMoreThanItStates) {
  int poses = 0;
  int far_off = 0;
  for (const double tilt_rad : {0.0, 0.05, 0.1}) {
    const LineModel model = tag_model(1, GetParam());
    const Isometry3 truth = tilted({45.0, 10.0, 590.0}, tilt_rad);
    for (const Measurement& one : seen(model, {.model = {model, model}, .pose = truth, .sigma_px = 0.1})) {
      if (!one.pose) continue;
      const Vec3 turn_rad = error_of(*one.pose, truth).tail<3>();
      const Matrix3 spread = one.pose->noise.bottomRightCorner<3, 3>();
      ++poses;
      far_off += turn_rad.dot(spread.ldlt().solve(turn_rad)) > 36.0 ? 1 : 0;
    }
  }
  std::cout << poses << " poses of a tag of " << GetParam() << " mm, " << far_off << " beyond six deviations\n";
  EXPECT_GT(poses, 10);
  EXPECT_EQ(far_off, 0);
}

}  // namespace
}  // namespace tripoint
