// LEDs that are switched: pictures in which they are out, and LEDs that are known by their blinking.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <variant>
#include <vector>

#include "blinking_observations.h"
#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint {
namespace {

using testing::at_rest;
using testing::blinking;
using testing::model_of;
using testing::Path;
using testing::score;
using testing::shared_model;
using testing::Shooting;
using testing::verdicts;

TEST(LineModulationTest, PicturesWithLedsOutBringNoVerdictAndKeepTheCameraAlive) {
  Line line(shared_model(model_of(1)));
  std::vector<Event> events = blinking({at_rest({10.0, 15.0, 400.0})}, {});
  for (const Event& event : events) {
    Observation out = std::get<Observation>(event);
    out.leds_out = true;
    out.points.clear();
    const std::optional<Measurement> verdict = line.step(out);
    const Faults faults = verdict ? verdict->faults : Faults{Fault::kTimingBound};
    EXPECT_EQ(faults, Faults{Fault::kTimingBound}) << "what lasts is told, and no camera is lost";
  }
}

TEST(LineModulationTest, PicturesLeftOutOnPurposeAreNotDropped) {
  std::vector<Event> events = blinking({at_rest({10.0, 15.0, 400.0})}, {});
  for (const Measurement& verdict : verdicts(model_of(1), events)) EXPECT_TRUE(verdict.warnings.empty());
  std::erase_if(events, [](const Event& event) { return std::get<Observation>(event).frame == 62; });
  int warned = 0;
  for (const Measurement& verdict : verdicts(model_of(1), events)) warned += verdict.warnings.empty() ? 0 : 1;
  EXPECT_GT(warned, 0);
}

TEST(LineModulationTest, AMovingLedIsMeasuredAcrossThePicturesInWhichItIsOut) {
  for (const double speed_mm_per_s : {50.0, 100.0, 250.0}) {
    Shooting shooting = testing::free_running();
    for (const Side side : kBothSides) shooting.timing[side].drop_share = 0.0;
    const Path path = testing::circle(speed_mm_per_s);
    const auto found = score(verdicts(model_of(1), blinking({path}, shooting)), path, 3.0);
    EXPECT_LT(found.worst_sigmas, 5.0) << speed_mm_per_s;
    if (speed_mm_per_s > 100.0) continue;  // what time adds is mostly beyond the bound
    EXPECT_GT(found.inside_share, 0.93) << speed_mm_per_s;
    EXPECT_GT(found.valid_share, 0.98) << speed_mm_per_s;
  }
}

TEST(LineModulationTest, APathThatTurnsRoundAtOnceStaysWithinItsStatedUncertainty) {
  const Path path = [](double time_s) -> Vec3 {  // 50 mm along the baseline and back, for ever, 50 mm/s
    const double phase = std::fmod(time_s, 2.0);
    return {50.0 * std::min(phase, 2.0 - phase) - 25.0, 10.0, 400.0};
  };
  for (int phase = 0; phase < 10; ++phase) {
    Shooting shooting;
    shooting.duration_s = 20.0;
    shooting.timing.left.phase_s = 0.0033 * phase;
    shooting.timing.right.phase_s = 0.0127;
    const auto found = score(verdicts(model_of(1), blinking({path}, shooting)), path, 3.0);
    EXPECT_LT(found.worst_sigmas, 4.0) << phase;  // two for the corner; of 600 poses the noise of one has more than 3
    EXPECT_GE(found.valid_share, 0.8) << phase;   // around a corner some are refused: fault 9
  }
}

TEST(LineModulationTest, SeveralLedsGiveAPoseAndTheirPointsTheirIds) {
  const std::vector<Path> leds{at_rest({-40, 0, 400}), at_rest({0, 40, 410}), at_rest({45, -20, 390})};
  LineModel model = model_of(3);
  for (std::size_t i = 0; i < leds.size(); ++i) {
    // The target is turned by half a turn about x, its first LED is its origin.
    const Vec3 from_first_mm = leds[i](0.0) - leds[0](0.0);
    model.target.points[i].in_target_mm = {from_first_mm.x(), -from_first_mm.y(), -from_first_mm.z()};
  }
  const auto found = verdicts(model, blinking(leds, {}));
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.back().faults.empty());
  ASSERT_TRUE(found.back().pose && found.back().pose->output_from_target);
  EXPECT_LT((found.back().pose->position_in_output_mm - leds[0](0.0)).norm(), 2.0);
  std::set<int> ids;
  for (const MeasuredPoint& point : found.back().points) {
    ids.insert(point.id);
    const Vec3 truth_mm = leds.at(static_cast<std::size_t>(point.id - 11))(0.0);
    EXPECT_LT((point.in_output_mm - truth_mm).norm(), 2.0) << point.id;
  }
  EXPECT_EQ(ids, (std::set<int>{11, 12, 13}));
}

TEST(LineModulationTest, LedsThatBlinkAsOthersThanGeometrySaysGiveNoPose) {
  const std::vector<Path> leds{at_rest({-40, 0, 400}), at_rest({0, 40, 410}), at_rest({45, -20, 390})};
  LineModel model = model_of(3);
  for (std::size_t i = 0; i < leds.size(); ++i) {
    const Vec3 from_first_mm = leds[(i + 1) % leds.size()](0.0) - leds[0](0.0);  // each is where the next should be
    model.target.points[i].in_target_mm = {from_first_mm.x(), -from_first_mm.y(), -from_first_mm.z()};
  }
  const auto found = verdicts(model, blinking(leds, {}));
  ASSERT_FALSE(found.empty());
  EXPECT_FALSE(found.back().pose);
  EXPECT_EQ(found.back().faults, Faults{Fault::kGeometryGate});
}

TEST(LineModulationTest, TwoLedsThatStandWhereTheOtherWasAreNotJoined) {
  const auto swapping = [](double from, double to) -> Path {
    return [=](double time_s) -> Vec3 { return {std::fmod(time_s, 1.0) < 0.5 ? from : to, 0.0, 400.0}; };
  };
  Shooting shooting;
  shooting.timing.right.phase_s = 0.011;  // so that the right camera is interpolated
  const auto found = verdicts(model_of(2), blinking({swapping(-20.0, 20.0), swapping(20.0, -20.0)}, shooting));
  int published = 0;
  for (const Measurement& verdict : found) {
    for (const MeasuredPoint& point : verdict.points) {
      ++published;
      EXPECT_NEAR(std::abs(point.in_output_mm.x()), 20.0, 2.0) << "between the two places there was nothing";
    }
  }
  EXPECT_GT(published, 100);
}

}  // namespace
}  // namespace tripoint
