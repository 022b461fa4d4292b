#include "line/pose/whole_fit.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "bench/erring_units.h"
#include "bench/seen_tags.h"
#include "line/pose/locate.h"
#include "sim/default_rig.h"

namespace tripoint {
namespace {

constexpr double kTarget_mm = 0.02;  // standard deviation
constexpr double kClock_s = 0.4e-3;  // likewise, of the right camera's: 0.16 px, many times what the edges err by
const Vec2 kVelocity_px_per_s(400.0, 60.0);
const bench::ErrorSources kSources{.spot_px = 0.0, .target_mm = kTarget_mm, .calibration_px = 0.1};

Isometry3 pose() {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(0.5, Vec3(0.6, 0.8, 0.0)) * Eigen::AngleAxisd(0.3, Vec3::UnitZ())).toRotationMatrix();
  pose.translation() = Vec3(15.0, -20.0, 410.0);
  return pose;
}

Target two_tags() {
  Target target;
  bench::add_tag(target, 0, 30.0, {-30.0, -10.0, 0.0}, 2.0 * kTarget_mm);
  bench::add_tag(target, 1, 30.0, {30.0, 5.0, 0.0}, 2.0 * kTarget_mm);
  return target;
}

/// Corners as a camera without distortion sees them, with all that they err by.
class ErringCorners {
 public:
  explicit ErringCorners(std::uint64_t seed) : random_(seed) {}

  /// @return the least chi-square of `two_tags`
  double chi2() {
    LineModel believed = units_.model({}, random_);
    believed.target = two_tags();
    const std::vector<LocatedPoint> corners = located_corners(believed);
    return whole_fit(corners, believed, pose()).value().chi2;
  }

 private:
  PerSide<Observation> seen() {
    LineModel truth;
    truth.rig = rig_of(truth_).value();
    truth.target = two_tags();
    std::normal_distribution<double> normal(0.0, kTarget_mm);
    for (TargetTag& tag : truth.target.tags) {
      for (Vec3& corner_mm : tag.corners_mm) corner_mm += Vec3::NullaryExpr([&] { return normal(random_); });
    }
    PerSide<Observation> pictures;
    for (const Side side : kBothSides) {
      pictures[side].side = side;
      bench::add_tags(pictures[side], truth, pose(), {.edge_px = 0.02, .corner_px = 0.01}, random_);
    }
    return pictures;
  }

  std::vector<LocatedPoint> located_corners(const LineModel& believed) {
    const PerSide<Observation> pictures = seen();
    const double late_s = kClock_s * std::normal_distribution<double>()(random_);  // of the right picture
    std::vector<LocatedPoint> corners;
    for (std::size_t i = 0; i < pictures.left.points.size(); ++i) {
      Pair pair;
      for (const Side side : kBothSides) pair.points[side].seen = pictures[side].points[i];
      AlignedPoint& right = pair.points.right;
      right.seen.at.u_px += late_s * kVelocity_px_per_s.x();
      right.seen.at.v_px += late_s * kVelocity_px_per_s.y();
      right.velocity_px_per_s = kVelocity_px_per_s;
      right.timing_px2 = kClock_s * kClock_s * kVelocity_px_per_s * kVelocity_px_per_s.transpose();
      const TargetTag& tag = believed.target.tags[i / kTagCorners];
      corners.push_back(
          located(pair, {tag.id, tag.corners_mm[i % kTagCorners], tag.uncertainty_mm, std::nullopt}, {}, believed)
              .value());
      corners.back().next = i - i % kTagCorners + (i + 1) % kTagCorners;
      for (const Side side : kBothSides) {
        corners.back().shared_with_next_px2[side] = pictures[side].points[i].shared_with_next_px2;
      }
    }
    return corners;
  }

  std::mt19937_64 random_;
  StereoCalibration truth_ = undistorted(default_rig());
  bench::ErringUnits units_{truth_, kSources};

  static StereoCalibration undistorted(StereoCalibration rig) {
    for (const Side side : kBothSides) rig.cameras[side].distortion = {};
    return rig;
  }
};

// Eight corners in two pictures leave 26 degrees of freedom. The mean of 2,000 chi-squares has a standard deviation of
// sqrt(2 * 26 / 2000) = 0.16, their variance of 52 one of 52 sqrt((2 + 12 / 26) / 2000) = 1.8; the ranges are four.
TEST(WholeFitTest, CountsWhateverThePointsErrByAsChiSquareDoes) {
  ErringCorners corners(7);
  constexpr int kDraws = 2000;
  double sum = 0.0;
  double squares = 0.0;
  int rare = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const double chi2 = corners.chi2();
    sum += chi2;
    squares += std::pow(chi2 - 26.0, 2);
    rare += chi2 > most_chi2(8) ? 1 : 0;
  }
  EXPECT_NEAR(sum / kDraws, 26.0, 0.65);
  EXPECT_NEAR(squares / kDraws, 52.0, 7.3);
  EXPECT_LE(rare, 8);  // more than 8 of 2,000 at 1 in 1,000 have a chance of 2e-4
}

// Upper quantiles at 0.001 for 4 n - 6 degrees of freedom, by the sum that chi-square is for even ones.
TEST(MostChi2Test, IsExceededOnceInAThousandTimes) {
  EXPECT_NEAR(most_chi2(3), 22.458, 0.01 * 22.458);
  EXPECT_NEAR(most_chi2(4), 29.588, 0.01 * 29.588);
  EXPECT_NEAR(most_chi2(12), 76.084, 0.01 * 76.084);
  EXPECT_NEAR(most_chi2(48), 251.339, 0.01 * 251.339);
}

}  // namespace
}  // namespace tripoint
