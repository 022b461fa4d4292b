// MJPEG cameras whose pictures are decoded around the forecast, from rendered JPEG data to verdicts: what a camera's
// thread and the measuring thread do, one after the other and on the time of the pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "capture/band_choice.h"
#include "capture/mjpeg_decoder.h"
#include "line/detect/led_detector.h"
#include "line/line.h"
#include "sim/default_rig.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(33);
constexpr int kLampAppears = 33;
constexpr int kFirstOfPhases = 33;
const std::vector<Vec3> kOneLed{Vec3::Zero()};
const std::vector<Vec3> kThreeLeds{Vec3::Zero(), {50.0, 0.0, 0.0}, {0.0, 35.0, 10.0}};

/// 300 mm/s to the right and 60 mm/s down.
Vec3 led_at(double time_s) { return {-60.0 + 300.0 * time_s / 3.0, -40.0 + 60.0 * time_s / 3.0, 390.0}; }

SimulatedWorld world_of(const Scene& scene, const Vec3& shift_mm = Vec3::Zero()) {
  SimulationSettings settings;
  settings.format = PixelFormat::kMjpeg;
  settings.line_time = Duration{0};
  settings.scene = scene;
  settings.trajectory = {.period = std::chrono::seconds{10}, .reference_from_target = [shift_mm](double time_s) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = led_at(time_s) + shift_mm;
                           return pose;
                         }};
  return SimulatedWorld::create(settings).value();
}

SimulatedWorld world_with(const std::vector<LightSource>& lamps) {
  Scene scene = led_scene(kOneLed);
  for (const LightSource& lamp : lamps) scene.lights.push_back(lamp);
  return world_of(scene);
}

/// Without its last LED.
SimulatedWorld world_with_one_hidden(const std::vector<Vec3>& leds) {
  Scene scene = led_scene(leds);
  scene.lights.pop_back();
  return world_of(scene);
}

LineModel model_of_default_rig(const std::vector<Vec3>& leds) {
  LineModel model;
  model.calibration = default_rig();
  model.rig = rig_of(model.calibration).value();
  for (const Vec3& led : leds) {
    model.target.points.push_back({.id = static_cast<int>(model.target.points.size()) + 1, .in_target_mm = led});
  }
  model.target.facing = -Vec3::UnitZ();
  model.volume = WorkingVolume{{-200.0, -200.0, 250.0}, {200.0, 200.0, 600.0}};
  model.limits.offset_prior_s = 1e-4;
  return model;
}

struct Verdict {
  int frame = 0;
  PerSide<Coverage> coverage{Coverage::kWholeFrame, Coverage::kWholeFrame};
  PerSide<std::size_t> spots{0, 0};
  Measurement measurement{};
  double error_mm = 0.0;  ///< of the pose, when there is one
};

/// Two cameras that expose together, and the line behind them.
class Tracking {
 public:
  using World = std::function<const SimulatedWorld&(int frame)>;

  explicit Tracking(const std::vector<Vec3>& leds = kOneLed)
      : line_(std::make_shared<const LineModel>(model_of_default_rig(leds))) {}

  std::vector<Verdict> run(const World& world, int frames, const std::function<Vec3(int frame)>& truth) {
    std::vector<Verdict> verdicts;
    for (int frame = 0; frame < frames; ++frame) {
      Verdict verdict{.frame = frame};
      std::optional<Measurement> measured;
      for (const Side side : kBothSides) {
        const Observation seen = observe(world(frame), side, frame);
        verdict.coverage[side] = seen.coverage;
        verdict.spots[side] = seen.points.size();
        if (const auto one = line_.step(seen)) measured = one;
      }
      forecast_ = line_.forecast();
      if (!measured) continue;
      verdict.measurement = *measured;
      if (measured->pose) verdict.error_mm = (measured->pose->position_in_output_mm - truth(frame)).norm();
      verdicts.push_back(verdict);
    }
    return verdicts;
  }

 private:
  Observation observe(const SimulatedWorld& world, Side side, int frame) {
    const auto number = static_cast<std::uint32_t>(frame);
    const RenderedFrame rendered = render(world, side, frame * kPeriod, number);
    const TimePoint exposed = TimePoint{} + std::chrono::seconds(1) + frame * kPeriod;
    Eye& eye = eyes_[side];
    const RowBands bands = chosen_bands(eye.sightings, forecast_, {side, number, exposed, rendered.size});
    const Picture picture = eye.decoder.decode(rendered.pixels, rendered.size, bands).value();
    const Detection found = eye.detector.detect(picture, forecast_);
    Observation seen;
    seen.side = side;
    seen.frame = number;
    seen.exposed = exposed;
    seen.arrived = exposed + std::chrono::milliseconds(20);
    seen.forecast_used = forecast_.number;
    seen.coverage = picture.bands.empty() ? Coverage::kWholeFrame : Coverage::kRegions;
    seen.points = found.points;
    seen.health = found.health;
    eye.sightings = with(eye.sightings, seen, forecast_);
    return seen;
  }

  struct Eye {
    MjpegDecoder decoder;
    LedDetector detector{LedDetectorSettings{}};
    Sightings sightings;
  };
  PerSide<Eye> eyes_;
  Line line_;
  Forecast forecast_;
};

Vec3 true_place(int frame) { return led_at(seconds(frame * kPeriod)); }

bool by_regions(const Verdict& verdict) {
  return verdict.coverage.left == Coverage::kRegions && verdict.coverage.right == Coverage::kRegions;
}

/// 0.1 px in each picture are 0.35 mm of depth here, 2 mm six times that; another spot is tens of millimetres away.
constexpr double kSameSpot_mm = 2.0;

TEST(TrackingTest, FourOfFivePicturesAreSeenByRegionsAndEveryOneGivesAPose) {
  const SimulatedWorld world = world_with({});
  const auto verdicts = Tracking().run([&](int) -> const SimulatedWorld& { return world; }, 60, true_place);
  int regions = 0;
  for (const Verdict& verdict : verdicts) {
    if (verdict.frame < 3) continue;  // until something is known
    EXPECT_TRUE(verdict.measurement.pose) << verdict.frame;
    EXPECT_LT(verdict.error_mm, kSameSpot_mm) << verdict.frame;
    regions += by_regions(verdict) ? 1 : 0;
  }
  EXPECT_GE(regions, 43);  // 57 times 4/5, less the start
}

TEST(TrackingTest, AnotherLampIsNoticedAtTheNextWholePictureAndNeverTaken) {
  LightSource lamp;
  lamp.mount = Mount::kReference;
  lamp.place_mm = {30.0, 110.0, 400.0};
  const SimulatedWorld without = world_with({});
  const SimulatedWorld with_lamp = world_with({lamp});
  const auto verdicts = Tracking().run(
      [&](int frame) -> const SimulatedWorld& { return frame < kLampAppears ? without : with_lamp; }, 60, true_place);
  bool noticed = false;
  for (const Verdict& verdict : verdicts) {
    if (verdict.measurement.pose) {
      EXPECT_LT(verdict.error_mm, kSameSpot_mm) << verdict.frame;
    }
    if (verdict.frame < kLampAppears) continue;
    noticed = noticed || !by_regions(verdict);
    if (noticed) {
      EXPECT_FALSE(verdict.measurement.pose) << verdict.frame;
      EXPECT_TRUE(verdict.measurement.faults.contains(Fault::kAmbiguous)) << verdict.frame;
      EXPECT_EQ(verdict.spots.left, 2U) << verdict.frame;
    }
    EXPECT_TRUE(noticed || verdict.frame < kLampAppears + static_cast<int>(kFramesPerWhole)) << verdict.frame;
  }
  EXPECT_TRUE(by_regions(verdicts[static_cast<std::size_t>(kLampAppears)])) << "nothing was tried";
}

bool by_no_region(const Verdict& verdict) {
  return verdict.coverage.left == Coverage::kWholeFrame && verdict.coverage.right == Coverage::kWholeFrame;
}

/// Something happens in one frame: each of the phases in which it finds the count of whole pictures.
class TrackingInEachPhaseTest : public testing::TestWithParam<int> {
 protected:
  /// Each pose is true, from the third frame on there is one again, and later it is tracked by regions again.
  static void expect_back_within_three(const std::vector<Verdict>& verdicts) {
    for (const Verdict& verdict : verdicts) {
      if (verdict.measurement.pose) {
        EXPECT_LT(verdict.error_mm, kSameSpot_mm) << verdict.frame;
      }
      if (verdict.frame >= GetParam() + 3) {
        EXPECT_TRUE(verdict.measurement.pose) << verdict.frame;
      }
    }
    EXPECT_TRUE(by_regions(verdicts[50]) || by_regions(verdicts[51])) << "it is never tracked again";
  }

  /// The frame in which it happens; what was seen whole less than five frames before is seen by regions.
  static const Verdict& in_question(const std::vector<Verdict>& verdicts) {
    const Verdict& verdict = verdicts[static_cast<std::size_t>(GetParam())];
    EXPECT_EQ(verdict.frame, GetParam());
    const auto first = verdicts.begin() + GetParam() - static_cast<std::ptrdiff_t>(kFramesPerWhole) + 1;
    const bool whole_lately = std::any_of(first, verdicts.begin() + GetParam(), by_no_region);
    EXPECT_EQ(by_regions(verdict), whole_lately) << verdict.frame;
    EXPECT_EQ(by_no_region(verdict), !whole_lately) << verdict.frame;
    return verdict;
  }
};

TEST_P(TrackingInEachPhaseTest, ALedThatJumpsOutOfItsRegionIsBackWithinThreeFrames) {
  const Vec3 jump_mm(20.0, 60.0, 15.0);  // 95 px down
  const SimulatedWorld here = world_with({});
  const SimulatedWorld there = world_of(led_scene(kOneLed), jump_mm);
  const auto jumped = [](int frame) { return frame >= GetParam(); };
  const auto verdicts =
      Tracking().run([&](int frame) -> const SimulatedWorld& { return jumped(frame) ? there : here; }, 60,
                     [&](int frame) -> Vec3 { return true_place(frame) + (jumped(frame) ? jump_mm : Vec3::Zero()); });
  const Verdict& at_jump = in_question(verdicts);
  if (by_regions(at_jump)) {
    EXPECT_EQ(at_jump.measurement.faults, (Faults{Fault::kNotSeenLeft, Fault::kNotSeenRight}));
  } else {
    EXPECT_EQ(at_jump.spots.left, 1U);
  }
  for (int frame = GetParam() + 1; frame < 60; ++frame) {
    EXPECT_EQ(verdicts[static_cast<std::size_t>(frame)].spots.left, 1U) << frame;
  }
  expect_back_within_three(verdicts);
}

TEST_P(TrackingInEachPhaseTest, ALedThatIsHiddenForOneFrameIsBackWithinThree) {
  const SimulatedWorld lit = world_with({});
  const SimulatedWorld dark = world_with_one_hidden(kOneLed);
  const auto verdicts = Tracking().run(
      [&](int frame) -> const SimulatedWorld& { return frame == GetParam() ? dark : lit; }, 60, true_place);
  const Verdict& hidden = in_question(verdicts);
  EXPECT_EQ(hidden.measurement.faults, (Faults{Fault::kNotSeenLeft, Fault::kNotSeenRight}));
  EXPECT_FALSE(hidden.measurement.pose);
  expect_back_within_three(verdicts);
}

TEST_P(TrackingInEachPhaseTest, OneOfThreeLedsThatIsMissedInOneFrameIsBackWithinThree) {
  const SimulatedWorld lit = world_of(led_scene(kThreeLeds));
  const SimulatedWorld without_one = world_with_one_hidden(kThreeLeds);
  const auto verdicts =
      Tracking(kThreeLeds)
          .run([&](int frame) -> const SimulatedWorld& { return frame == GetParam() ? without_one : lit; }, 60,
               true_place);
  const Verdict& missed = in_question(verdicts);
  EXPECT_EQ(missed.spots.left, 2U);
  EXPECT_FALSE(missed.measurement.pose);
  for (int frame = GetParam() + 3; frame < 60; ++frame) {
    EXPECT_EQ(verdicts[static_cast<std::size_t>(frame)].spots.left, 3U) << frame;
  }
  expect_back_within_three(verdicts);
}

INSTANTIATE_TEST_SUITE_P(Phases, TrackingInEachPhaseTest,
                         testing::Range(kFirstOfPhases, kFirstOfPhases + static_cast<int>(kFramesPerWhole)),
                         [](const auto& phase) { return "Frame" + std::to_string(phase.param); });

}  // namespace
}  // namespace tripoint
