// Pictures seen by regions: believed only while a whole picture, not long ago, showed nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::verdicts;
using testing::webcam_model;

const testing::Path kPath = testing::circle(100.0);

/// Two seconds of both cameras, each picture as `change` makes it.
std::vector<Event> shot_with(const std::function<void(Observation&)>& change) {
  testing::Shooting shooting;
  shooting.timing.right.phase_s = 0.010;
  shooting.duration_s = 2.0;
  std::vector<Event> events = testing::shot(webcam_model(), {kPath}, shooting);
  for (Event& event : events) change(std::get<Observation>(event));
  return events;
}

void see_by_regions_but_every(Observation& seen, std::uint32_t period) {
  if (seen.frame % period != 0) seen.coverage = Coverage::kRegions;
}

/// A spot of the left picture that no spot of the right one belongs to: the epipolar gate alone would sort it out.
void add_other_spot(Observation& seen) {
  ImagePoint other = seen.points[0];
  other.at = {600.0, 30.0};
  seen.points.push_back(other);
}

std::size_t poses(const std::vector<Measurement>& found) {
  std::size_t count = 0;
  for (const Measurement& one : found) count += one.pose ? 1U : 0U;
  return count;
}

TEST(LineRegionsTest, EveryFifthPictureWholeGivesTheSamePosesAsAllWhole) {
  const auto whole = verdicts(webcam_model(), shot_with([](Observation&) {}));
  const auto regions =
      verdicts(webcam_model(), shot_with([](Observation& seen) { see_by_regions_but_every(seen, 5); }));
  ASSERT_EQ(whole.size(), regions.size());
  ASSERT_GT(poses(whole), 50U);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].faults.bits(), regions[i].faults.bits());
    ASSERT_EQ(whole[i].pose.has_value(), regions[i].pose.has_value());
    if (!whole[i].pose) continue;
    EXPECT_EQ(whole[i].pose->position_in_output_mm, regions[i].pose->position_in_output_mm);
  }
}

TEST(LineRegionsTest, NothingIsBelievedBeforeAWholePicture) {
  for (const Side side : kBothSides) {
    const auto found = verdicts(webcam_model(), shot_with([side](Observation& seen) {
                                  if (seen.side == side) seen.coverage = Coverage::kRegions;
                                }));
    EXPECT_EQ(poses(found), 0U);
    EXPECT_TRUE(found.back().faults.contains(Fault::kAmbiguous));
  }
}

TEST(LineRegionsTest, AWholePictureFiveFramesBackIsTooOld) {
  const auto events = shot_with([](Observation& seen) { see_by_regions_but_every(seen, 6); });
  Line line(testing::shared_model(webcam_model()));
  PerSide<std::uint32_t> newest{0, 0};
  std::size_t refused = 0;
  for (const Event& event : events) {
    const auto& seen = std::get<Observation>(event);
    newest[seen.side] = seen.frame;
    const auto found = line.step(event);
    if (!found || newest.left < 4 || newest.right < 4) continue;  // before, nothing is followed yet
    const bool too_old = newest.left % 6 == 5 || newest.right % 6 == 5;
    EXPECT_EQ(found->pose.has_value(), !too_old) << newest.left << " " << newest.right;
    EXPECT_EQ(found->faults.contains(Fault::kAmbiguous), too_old);
    refused += too_old ? 1U : 0U;
  }
  EXPECT_GT(refused, 5U);
}

TEST(LineRegionsTest, FramesThatWereDroppedCountAsFrames) {
  auto events = shot_with([](Observation& seen) { see_by_regions_but_every(seen, 5); });
  std::erase_if(events, [](const Event& event) {
    const auto& seen = std::get<Observation>(event);
    return seen.side == Side::kLeft && seen.frame == 30;  // the whole one
  });
  Line line(testing::shared_model(webcam_model()));
  for (const Event& event : events) {
    const auto found = line.step(event);
    const auto& seen = std::get<Observation>(event);
    if (!found || seen.side != Side::kLeft || seen.frame < 29 || seen.frame > 35) continue;
    EXPECT_EQ(found->pose.has_value(), seen.frame == 29 || seen.frame == 35) << seen.frame;
  }
}

TEST(LineRegionsTest, ASpotThatTheLastWholePictureShowedIsNotForgottenByNotLooking) {
  const auto events = shot_with([](Observation& seen) {
    see_by_regions_but_every(seen, 5);
    const bool appears = seen.side == Side::kLeft && seen.frame >= 30 && seen.frame < 45;
    if (appears && seen.coverage == Coverage::kWholeFrame) add_other_spot(seen);
  });
  Line line(testing::shared_model(webcam_model()));
  std::size_t refused = 0;
  for (const Event& event : events) {
    const auto found = line.step(event);
    const auto& seen = std::get<Observation>(event);
    if (!found || seen.side != Side::kRight || seen.frame < 27) continue;
    const bool elsewhere = seen.frame > 30 && seen.frame < 45 && seen.frame % 5 != 0;
    if (!elsewhere) continue;
    EXPECT_FALSE(found->pose) << seen.frame;
    EXPECT_TRUE(found->faults.contains(Fault::kAmbiguous)) << seen.frame;
    ++refused;
  }
  EXPECT_GT(refused, 8U);
  EXPECT_TRUE(verdicts(webcam_model(), events).back().pose);
}

TEST(LineRegionsTest, AWholePictureThatWasNotLookedAtToTheEndClearsNothing) {
  const auto found = verdicts(webcam_model(), shot_with([](Observation& seen) {
                                see_by_regions_but_every(seen, 5);
                                seen.health.candidates_cut = seen.coverage == Coverage::kWholeFrame;
                              }));
  EXPECT_EQ(poses(found), 0U);
}

TEST(LineRegionsTest, RegionsWithoutASpotSayNotSeenAndNothingElse) {
  const auto events = shot_with([](Observation& seen) {
    see_by_regions_but_every(seen, 5);
    if (seen.side == Side::kLeft && seen.frame >= 31 && seen.frame < 34) seen.points.clear();
  });
  Line line(testing::shared_model(webcam_model()));
  for (const Event& event : events) {
    const auto found = line.step(event);
    const auto& seen = std::get<Observation>(event);
    if (!found || seen.side != Side::kLeft || seen.frame < 31 || seen.frame > 33) continue;
    EXPECT_EQ(found->faults, Faults{Fault::kNotSeenLeft}) << seen.frame;
  }
}

TEST(LineRegionsTest, ANewModelNeedsNewWholePictures) {
  const auto events = shot_with([](Observation& seen) { see_by_regions_but_every(seen, 5); });
  Line line(testing::shared_model(webcam_model()));
  bool swapped = false;
  for (const Event& event : events) {
    const auto& seen = std::get<Observation>(event);
    if (seen.frame == 31 && !swapped) {
      line.swap_model(testing::shared_model(webcam_model()));
      swapped = true;
    }
    const auto found = line.step(event);
    if (!found || seen.frame <= 31 || seen.frame == 35 || seen.frame == 36) continue;
    EXPECT_EQ(found->pose.has_value(), seen.frame > 36) << seen.frame;
  }
}

}  // namespace
}  // namespace tripoint
