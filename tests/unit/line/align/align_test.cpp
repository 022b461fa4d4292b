#include "line/align/align.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "../synthetic_cameras.h"

namespace tripoint {
namespace {

using testing::picture;
using testing::spot_at;

constexpr double kSigma_px = 0.05;

/// Feeds pictures whose only spot moves as a function of time, and returns what the last one brought.
class AlignTest : public ::testing::Test {
 protected:
  Aligned take(const Event& event) {
    tracks_.take(event);
    clocks_.take(event);
    return align(tracks_, clocks_);
  }
  Aligned take(Side side, std::uint32_t frame, double exposed_s, std::vector<RawPixel> spots) {
    Observation seen = picture(side, frame, exposed_s);
    seen.exposure = exposure_[side];
    seen.line_time = line_time_[side];
    for (const RawPixel& spot : spots) seen.points.push_back(spot_at(spot, kSigma_px));
    return take(seen);
  }
  /// Both cameras at 30 fps, the right one 10 ms later, until just before the left picture `frames`.
  Aligned run(std::uint32_t frames, const std::function<RawPixel(double)>& where) {
    Aligned last;
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
      const double left_s = 1.0 + frame / 30.0;
      take(Side::kLeft, frame, left_s, {where(left_s)});
      last = take(Side::kRight, frame, left_s + 0.010, {where(left_s + 0.010)});
    }
    return last;
  }

  Tracks tracks_;
  Clocks clocks_;
  PerSide<std::optional<Duration>> exposure_;
  PerSide<Duration> line_time_;
};

double began_s(const Aligned& seen) { return seconds(seen.exposure_began.time_since_epoch()); }

RawPixel straight(double time_s) { return {100.0 + 90.0 * time_s, 80.0 + 30.0 * time_s}; }

TEST_F(AlignTest, IsExactInTheEarlierCameraAndOnTheStraightLineInTheOther) {
  const Aligned seen = run(20, straight);
  ASSERT_TRUE(seen.common_time);
  const double left_s = 1.0 + 19.0 / 30.0;
  EXPECT_NEAR(seconds(seen.at.time_since_epoch()), left_s, 1e-8);
  for (const Side side : kBothSides) {
    ASSERT_EQ(seen.points[side].size(), 1U);
    const AlignedPoint& point = seen.points[side][0];
    EXPECT_NEAR(point.seen.at.u_px, straight(left_s).u_px, 90.0 * 1e-8);  // speed times a nanosecond or two
    EXPECT_NEAR(point.seen.at.v_px, straight(left_s).v_px, 90.0 * 1e-8);
    EXPECT_NEAR(point.velocity_px_per_s->x(), 90.0, 1e-4);
    EXPECT_NEAR(point.velocity_px_per_s->y(), 30.0, 1e-4);
  }
  EXPECT_NEAR(seen.skew_s, 0.010, 1e-8);
}

TEST_F(AlignTest, InterpolationAveragesTheNoiseOfTwoPictures) {
  const Aligned seen = run(20, straight);
  const double share = (1.0 / 30.0 - 0.010) * 30.0;  // of the way from the picture before
  const double variance = kSigma_px * kSigma_px;
  EXPECT_NEAR(seen.points.left[0].seen.covariance_px2(0, 0), variance, 1e-12);
  EXPECT_NEAR(seen.points.right[0].seen.covariance_px2(0, 0),
              variance * (share * share + (1.0 - share) * (1.0 - share)), 1e-7);
  for (const Side side : kBothSides) {
    const AlignedPoint& point = seen.points[side][0];
    EXPECT_NEAR(point.seen.covariance_px2(0, 0) / point.averaging, variance, 1e-12);
  }
}

TEST_F(AlignTest, TheClocksOffsetSpreadsTheInterpolatedPointAlongItsMotionOnly) {
  clocks_.trust_offset_to(0.010);
  const Aligned seen = run(20, straight);
  EXPECT_EQ(seen.timed, Side::kRight);
  EXPECT_TRUE(seen.points.left[0].timing_px2.isZero(1e-12));
  EXPECT_GT(seen.offset_sigma_s, 0.010);
  const Vec2 along = seen.offset_sigma_s * Vec2(90.0, 30.0);
  EXPECT_TRUE(seen.points.right[0].timing_px2.isApprox(along * along.transpose(), 1e-4));
}

TEST_F(AlignTest, ABendIsLeftOutAndStated) {
  const auto bent = [](double time_s) -> RawPixel { return {100.0 + 0.5 * 900.0 * time_s * time_s, 80.0}; };
  const Aligned seen = run(20, bent);
  const double left_s = 1.0 + 19.0 / 30.0;
  const double error_px = seen.points.right[0].seen.at.u_px - bent(left_s).u_px;
  EXPECT_NEAR(error_px, 0.5 * 900.0 * 0.010 * (1.0 / 30.0 - 0.010), 1e-3);  // a/2 (t - t0)(t1 - t)
  EXPECT_GE(std::sqrt(seen.points.right[0].timing_px2(0, 0)), 0.999 * error_px);
}

TEST_F(AlignTest, IsDueOncePerNewCommonTime) {
  EXPECT_FALSE(take(Side::kLeft, 0, 1.000, {{100, 100}}).due);
  EXPECT_FALSE(take(Side::kRight, 0, 1.010, {{90, 100}}).due) << "the right track does not reach back to 1.000";
  EXPECT_TRUE(take(Side::kLeft, 1, 1.033, {{100, 100}}).due) << "1.010";
  EXPECT_TRUE(take(Side::kRight, 1, 1.043, {{90, 100}}).due) << "1.033";
  EXPECT_FALSE(take(Side::kRight, 2, 1.076, {{90, 100}}).due) << "still 1.033";
}

TEST_F(AlignTest, PicturesHalfAMillisecondApartAreOneCommonTime) {
  int due = 0;
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    due += take(Side::kLeft, frame, 1.0 + frame / 30.0, {{100, 100}}).due ? 1 : 0;
    due += take(Side::kRight, frame, 1.0005 + frame / 30.0, {{90, 100}}).due ? 1 : 0;
  }
  EXPECT_EQ(due, 19);
}

TEST_F(AlignTest, AGapOfMoreThanEightyMillisecondsIsNotBridged) {
  run(20, straight);
  for (const std::uint32_t missing : {1U, 2U}) {
    // left goes on without gap, right comes back after `missing` dropped pictures
    const std::uint32_t frame = tracks_[Side::kLeft].picture(0).frame + missing + 1;
    for (std::uint32_t left = frame - missing; left <= frame; ++left) {
      take(Side::kLeft, left, 1.0 + left / 30.0, {straight(1.0 + left / 30.0)});
    }
    const double right_s = 1.0 + frame / 30.0 + 0.010;
    const Aligned seen = take(Side::kRight, frame, right_s, {straight(right_s)});
    EXPECT_TRUE(seen.warnings.contains(Warning::kFramesDropped));
    EXPECT_EQ(seen.faults.contains(Fault::kTimingBound), missing == 2) << missing;
    EXPECT_EQ(seen.points.right.empty(), missing == 2) << missing;
  }
}

TEST_F(AlignTest, APointThatCannotBeFollowedIsAmbiguous) {
  run(20, straight);
  const double next_s = 1.0 + 20.0 / 30.0;
  take(Side::kLeft, 20, next_s, {straight(next_s)});
  const RawPixel at = straight(next_s + 0.010);
  const Aligned seen = take(Side::kRight, 20, next_s + 0.010, {{at.u_px + 20, at.v_px}, {at.u_px - 20, at.v_px}});
  EXPECT_TRUE(seen.faults.contains(Fault::kAmbiguous));
  EXPECT_TRUE(seen.points.right.empty());
}

TEST_F(AlignTest, APointThatAppearedAfterTheCommonTimeIsNotThereYetAndLeavesADoubt) {
  run(20, straight);
  const double next_s = 1.0 + 20.0 / 30.0;
  take(Side::kLeft, 20, next_s, {straight(next_s)});
  const Aligned seen = take(Side::kRight, 20, next_s + 0.010, {straight(next_s + 0.010), {600.0, 400.0}});
  EXPECT_EQ(seen.points.right.size(), 1U);
  EXPECT_EQ(seen.spots.right, 2);
  EXPECT_EQ(seen.faults, Faults{Fault::kAmbiguous}) << "it might be the partner of what the left camera sees";
}

TEST_F(AlignTest, AnUnknownSpeedIsAllowedForInEveryDirection) {
  clocks_.trust_offset_to(0.010);
  take(Side::kLeft, 0, 1.0, {{100, 100}});
  const Aligned seen = take(Side::kRight, 0, 1.0, {{90, 100}});
  ASSERT_TRUE(seen.due);
  EXPECT_GT(seen.points.right[0].timing_px2(0, 0), 1.0);
  EXPECT_GT(seen.points.right[0].timing_px2(1, 1), 1.0);
  EXPECT_FALSE(seen.points.right[0].velocity_px_per_s);
}

TEST_F(AlignTest, ThePicturesBeganHalfTheLongerExposureBeforeTheirMiddle) {
  exposure_ = {std::chrono::milliseconds(20), std::chrono::milliseconds(30)};
  take(Side::kLeft, 0, 1.0, {{100, 100}});
  EXPECT_NEAR(began_s(take(Side::kRight, 0, 1.0, {{90, 100}})), 1.0 - 0.015, 1e-8);
}

TEST_F(AlignTest, AnInterpolatedPointBeganWithTheEarlierOfItsPictures) {
  exposure_ = {std::chrono::milliseconds(4), std::chrono::milliseconds(4)};
  EXPECT_NEAR(began_s(run(20, straight)), 1.0 + 18.0 / 30.0 + 0.010 - 0.002, 1e-8);
}

TEST_F(AlignTest, AnUnknownExposureIsTakenForTheFramePeriod) {
  EXPECT_NEAR(began_s(run(20, straight)), 1.0 + 18.0 / 30.0 + 0.010 - 0.5 / 30.0, 1e-8);
}

TEST_F(AlignTest, AnUnknownExposureIsNotForgottenBeforeThePeriodIsKnown) {
  take(Side::kLeft, 0, 1.0, {{100, 100}});
  EXPECT_NEAR(began_s(take(Side::kRight, 0, 1.0, {{90, 100}})), 1.0 - 0.050, 1e-8) << "of a camera at 10 fps";
}

TEST_F(AlignTest, ALowRowMayNeedAPictureMoreThanTheFirstOne) {
  exposure_ = {std::chrono::milliseconds(4), std::chrono::milliseconds(4)};
  line_time_.right = std::chrono::microseconds(60);
  const auto right_s = [](std::uint32_t frame) { return 1.0 + frame / 30.0 - 0.005; };
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    take(Side::kRight, frame, right_s(frame), {{90, 10}, {300, 400}});
    take(Side::kLeft, frame, 1.0 + frame / 30.0, {{100, 10}});
  }
  const Aligned seen = take(Side::kRight, 20, right_s(20), {{90, 10}, {300, 400}});
  ASSERT_TRUE(seen.due);
  EXPECT_EQ(seen.points.right.size(), 2U);
  // row 400 of picture 19 was exposed 19 ms after the common time: picture 18 is the one before it
  EXPECT_NEAR(began_s(seen), right_s(18) + 400 * 60e-6 - 0.002, 1e-8);
}

}  // namespace
}  // namespace tripoint
