// Rendered pictures of LEDs that blink by their code among lamps that do not.
#include "modulation/blinking_leds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "line/detect/led_detector.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint {
namespace {

constexpr Duration kPeriod{33'333'333};
constexpr Duration kFirst = std::chrono::seconds(2);  // since 1970, and on the unit's clock

TimePoint time_of(int picture) { return TimePoint{kFirst + picture * kPeriod}; }

/// One camera's pictures, and what is believed of them. The LEDs are switched half-way between two exposures.
class Sight {
 public:
  explicit Sight(std::size_t leds) : code_(leds) {
    settings_.line_time = Duration{0};
    settings_.scene.lights.clear();
    for (std::size_t led = 0; led < leds; ++led) {
      LightSource light{.id = static_cast<int>(led) + 11, .place_mm = Vec3(30.0 * static_cast<double>(led), 0.0, 0.0)};
      light.switched_by = led;
      settings_.scene.lights.push_back(light);
      blink_.leds.push_back(static_cast<std::uint16_t>(light.id));
    }
    settings_.lit_share = [this](std::size_t line, Duration from, Duration) {
      return code_.lit_in(step_at(from)).contains(line) ? 1.0 : 0.0;
    };
  }

  void move(const Vec3& velocity_mm_per_s) {
    settings_.trajectory = {.period = std::chrono::seconds{1000}, .reference_from_target = [=](double time_s) {
                              Isometry3 pose = Isometry3::Identity();
                              pose.translation() = Vec3(-30.0, 0.0, 400.0) + (time_s - 2.0) * velocity_mm_per_s;
                              return pose;
                            }};
  }
  /// As an LED, but steady.
  LightSource& add_lamp(const Vec3& place_mm) {
    LightSource lamp{.mount = Mount::kReference, .place_mm = place_mm};
    settings_.scene.lights.push_back(lamp);
    return settings_.scene.lights.back();
  }

  struct Seen {
    Observation believed;
    FrameTruth truth;
    FixedVector<SpotVerdict, kMaxImagePoints> verdicts;
  };

  std::vector<Seen> look(int pictures, const std::function<bool(int)>& dropped = {}) {
    const SimulatedWorld world = SimulatedWorld::create(settings_).value();
    FrameRenderer renderer(world, Side::kLeft);
    BlinkingLeds blinking(blink_, log_, rhythm);
    std::vector<Seen> all;
    for (int i = 0; i < pictures; ++i) {
      log_.begin(time_of(i) - kPeriod / 2);
      log_.complete(time_of(i) - kPeriod / 2, code_.lit_in(static_cast<std::uint64_t>(i)));
      if (dropped && dropped(i)) continue;
      const RenderedFrame& frame = renderer.render(time_of(i).time_since_epoch(), static_cast<std::uint64_t>(i));
      const Picture picture = picture_of(frame_of(frame));
      Observation seen;
      seen.frame = static_cast<std::uint32_t>(i);
      seen.exposed = time_of(i) + stamp_error;
      seen.arrived = time_of(i) + std::chrono::milliseconds(10);
      seen.exposure = settings_.exposure;
      seen.points = detector_.detect(picture, {}).points;
      all.push_back({blinking.sifted(seen, picture), frame.truth, blinking.verdicts()});
    }
    return all;
  }

  Latest<std::optional<Rhythm>> rhythm;
  Duration stamp_error{0};

 private:
  std::uint64_t step_at(Duration time) const {
    return static_cast<std::uint64_t>((time - kFirst + kPeriod / 2) / kPeriod);
  }

  LedCode code_;
  SimulationSettings settings_;
  BlinkSettings blink_{.leds = {}, .stamp_error = std::chrono::milliseconds(3)};
  SwitchLog log_;
  LedDetector detector_{LedDetectorSettings{}};
};

/// Every believed point is the LED whose number it carries.
void expect_no_lamp(const std::vector<Sight::Seen>& all) {
  for (const Sight::Seen& seen : all) {
    for (const ImagePoint& point : seen.believed.points) {
      for (const LightTruth& light : seen.truth.lights) {
        if (light.id != point.led) continue;
        EXPECT_LT(std::hypot(point.at.u_px - light.at.u_px, point.at.v_px - light.at.v_px), 0.5)
            << "picture " << seen.believed.frame << " LED " << point.led;
      }
      EXPECT_NE(point.led, 0);
    }
  }
}

int pictures_with(const std::vector<Sight::Seen>& all, std::size_t points, std::uint32_t from = 0) {
  int count = 0;
  for (const Sight::Seen& seen : all) {
    count += seen.believed.frame >= from && !seen.believed.leds_out && seen.believed.points.size() == points ? 1 : 0;
  }
  return count;
}

TEST(BlinkingLedsTest, OneLedAmongSteadyLampsIsBelievedAlone) {
  Sight sight(1);
  sight.move(Vec3::Zero());
  sight.add_lamp({40.0, 20.0, 400.0});
  sight.add_lamp({-80.0, -30.0, 420.0});
  const auto all = sight.look(20);
  expect_no_lamp(all);
  EXPECT_EQ(pictures_with(all, 1, 8), 7) << "all are lit in steps 8, 10, 12, 13, 15, 17 and 18";
  EXPECT_EQ(all[15].verdicts.size(), 3U);
}

TEST(BlinkingLedsTest, InMotionBesideLampsAsWell) {
  for (const double speed_mm_per_s : {30.0, 250.0, -150.0}) {
    Sight sight(1);
    sight.move({speed_mm_per_s, 40.0, 0.0});
    sight.add_lamp({10.0, 30.0, 400.0});
    sight.add_lamp({60.0, -30.0, 400.0});
    const auto all = sight.look(16);
    expect_no_lamp(all);
    EXPECT_GE(pictures_with(all, 1, 8), 3) << speed_mm_per_s;
  }
}

TEST(BlinkingLedsTest, AnLedThatPassesALampIsNeverMeasuredTogetherWithIt) {
  Sight sight(1);
  sight.move({150.0, 0.0, 0.0});
  sight.add_lamp({20.0, 1.0, 400.0});  // passed after a third of a second
  const auto all = sight.look(24);
  expect_no_lamp(all);
  EXPECT_GE(pictures_with(all, 0, 8), 1) << "nothing was in the way";
}

TEST(BlinkingLedsTest, AMovingLampIsNone) {
  Sight sight(1);
  sight.move({100.0, 0.0, 0.0});
  LightSource& lamp = sight.add_lamp({20.0, 30.0, 0.0});
  lamp.mount = Mount::kTarget;
  const auto all = sight.look(16);
  expect_no_lamp(all);
  EXPECT_GE(pictures_with(all, 1, 8), 3);
}

TEST(BlinkingLedsTest, ThreeLedsCarryTheirNumbers) {
  Sight sight(3);
  sight.move({60.0, 20.0, 0.0});
  sight.add_lamp({10.0, 40.0, 400.0});
  const auto all = sight.look(22);
  expect_no_lamp(all);
  EXPECT_GE(pictures_with(all, 3, 12), 3);
}

TEST(BlinkingLedsTest, ADroppedPictureProvesNothing) {
  Sight sight(1);
  sight.move({30.0, 0.0, 0.0});
  sight.add_lamp({10.0, 40.0, 400.0});
  const auto every_dark_one = [](int i) { return i % 5 == 1 || i % 5 == 4; };
  EXPECT_EQ(pictures_with(sight.look(20, every_dark_one), 1), 0);
}

TEST(BlinkingLedsTest, StampsThatAreWrongByMoreThanTheyMayBeBelieveNothing) {
  Sight sight(1);
  sight.move(Vec3::Zero());
  sight.add_lamp({10.0, 40.0, 400.0});
  sight.stamp_error = -kPeriod;  // each picture is taken for the one before
  EXPECT_EQ(pictures_with(sight.look(20), 1), 0);
}

TEST(BlinkingLedsTest, TheRhythmIsThatOfTheRowsOfTheLed) {
  Sight sight(1);
  sight.move(Vec3::Zero());
  sight.look(10);
  const std::optional<Rhythm> rhythm = sight.rhythm.get();
  ASSERT_TRUE(rhythm);
  EXPECT_NEAR(seconds(rhythm->period), seconds(kPeriod), 1e-6);
  EXPECT_NEAR(seconds(rhythm->middle - time_of(9)), 0.0, 1e-6);
  EXPECT_NEAR(seconds(rhythm->half), 2.5e-3 + 3e-3, 1e-6);
}

}  // namespace
}  // namespace tripoint
