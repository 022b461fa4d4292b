#include "line/monitor/turn_evidence.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "line/pose/locate.h"
#include "watched_target.h"

namespace tripoint {
namespace {

using testing::knocked_rig;
using testing::kSpot_px;
using testing::kWatchedLeds;
using testing::view_by;
using testing::watched_model;

constexpr std::array<std::uint64_t, 4> kScenes{1, 2, 3, 4};

TurnEvidence evidence_of(const LineModel& model, const Pairs& pairs) {
  const auto points = located_target(pairs, Aligned{}, model);
  const std::span<const LocatedPoint> all{points->begin(), points->size()};
  return turn_evidence(all, pose_of_widest_triangle(all), model).value_or(TurnEvidence{});
}

TurnEvidence evidence_of(const LineModel& model, const TargetView& view) {
  LineModel tolerant = model;  // identifies what the model would refuse
  tolerant.covariance.diagonal().segment<3>(18).setConstant(1e-5);
  const Pairs pairs = match(bench::as_seen(view, kSpot_px), tolerant);
  EXPECT_EQ(pairs.pairs.size(), kWatchedLeds.size());
  return evidence_of(model, pairs);
}

Vec3 turn_of(const TurnEquations& equations) {
  return equations.middleCols<3>(kTurnColumn).inverse() * equations.col(kSeenColumn);
}

TEST(TurnEvidenceTest, WithoutATurnThereIsNone) {
  for (const std::uint64_t scene : kScenes) {
    const TurnEvidence evidence = evidence_of(watched_model(), view_by(default_rig(), scene));
    EXPECT_LT(turn_of(evidence.equations).norm(), 1e-9);
    EXPECT_NEAR(evidence.side_error_mm, 0.0, 1e-9);
  }
}

// The calibration lies behind the cameras: what it is off by is the turn back.
TEST(TurnEvidenceTest, TheTurnOfTheRightCameraIsFoundAboutEachAxis) {
  for (const std::uint64_t scene : kScenes) {
    for (const Vec3& turn_rad : {Vec3(3e-4, 0.0, 0.0), Vec3(0.0, 3e-4, 0.0), Vec3(0.0, 0.0, 3e-4)}) {
      const TurnEvidence evidence = evidence_of(watched_model(), view_by(knocked_rig(turn_rad), scene));
      EXPECT_LT((turn_of(evidence.equations) + turn_rad).norm(), 0.02 * turn_rad.norm()) << turn_rad.transpose();
    }
  }
}

TEST(TurnEvidenceTest, ItKnowsWhatAnErrorOfTheCalibrationWouldDo) {
  const StereoCalibration truth = default_rig();
  const PerSide<ImageSize> sizes{truth.cameras.left.size, truth.cameras.right.size};
  RigParameters step;  // a few hundredths of a pixel each
  for (int camera = 0; camera < 2; ++camera) {
    step.segment<9>(9 * camera) << 0.05, 0.05, 0.05, 0.05, 3e-4, 3e-4, 3e-5, 3e-5, 3e-4;
  }
  step.tail<6>() << 3e-5, 3e-5, 3e-5, 0.01, 0.01, 0.01;
  const TargetView view = view_by(truth, 1);
  for (int parameter = 0; parameter < 24; ++parameter) {
    RigParameters off = parameters_of(truth);
    off[parameter] += step[parameter];
    const TurnEquations seen = evidence_of(watched_model(calibration_of(off, sizes)), view).equations;
    const Vec3 foretold = step[parameter] * seen.col(kCalibrationColumn + parameter);
    EXPECT_LT((seen.col(kSeenColumn) - foretold).norm(), 0.02 * foretold.norm() + 1.0) << parameter;
  }
}

TEST(TurnEvidenceTest, ItKnowsWhatAMisplacedLedWouldDo) {
  for (int coordinate = 0; coordinate < 9; ++coordinate) {
    std::array<Vec3, 3> made_mm = kWatchedLeds;
    made_mm[static_cast<std::size_t>(coordinate / 3)][coordinate % 3] -= 0.02;  // the target file says more
    const TurnEquations seen = evidence_of(watched_model(), view_by(default_rig(), 1, made_mm)).equations;
    const Vec3 foretold = 0.02 * seen.col(kTargetColumn + coordinate);
    EXPECT_LT((seen.col(kSeenColumn) - foretold).norm(), 0.02 * foretold.norm() + 1.0) << coordinate;
  }
}

TEST(TurnEvidenceTest, ATargetThatIsMadeLargerHasLongerSides) {
  std::array<Vec3, 3> made_mm = kWatchedLeds;
  for (Vec3& led_mm : made_mm) led_mm *= 1.001;
  EXPECT_NEAR(evidence_of(watched_model(), view_by(default_rig(), 1, made_mm)).side_error_mm, 0.08, 1e-6);
}

TEST(TurnEvidenceTest, ItKnowsWhatAWrongClockWouldDo) {
  const LineModel model = watched_model();
  Pairs pairs = match(bench::as_seen(view_by(default_rig(), 1), kSpot_px), model);
  ASSERT_EQ(pairs.pairs.size(), kWatchedLeds.size());
  const Vec2 moved_px(0.03, 0.04);
  for (Pair& pair : pairs.pairs) {
    AlignedPoint& timed = pair.points.right;
    timed.velocity_px_per_s = 100.0 * moved_px;
    timed.timing_px2 = moved_px * moved_px.transpose();
    timed.seen.at.u_px += moved_px.x();
    timed.seen.at.v_px += moved_px.y();
  }
  const TurnEquations seen = evidence_of(model, pairs).equations;
  const Vec3 foretold = seen.col(kClockColumn + 2);
  EXPECT_GT(foretold.norm(), 1.0);
  EXPECT_LT((seen.col(kSeenColumn) - foretold).norm(), 0.02 * foretold.norm());
}

}  // namespace
}  // namespace tripoint
