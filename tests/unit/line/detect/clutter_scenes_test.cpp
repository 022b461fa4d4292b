// The detector in varied scenes full of what is like an LED and is none: what it finds, and what it must not believe.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "bench/clutter_scoring.h"
#include "capture/mjpeg_decoder.h"
#include "sim/clutter.h"

namespace tripoint {
namespace {

using bench::LedScore;
using bench::Origin;
using bench::PointScore;
using bench::ViewScore;

struct Tally {
  int asked = 0;
  int found = 0;
  int in_95 = 0;
  int wrong_pairs = 0;  ///< points in space of which something is no red light
  std::string missed{};
  std::string believed{};  ///< in single views, that must be refused
};

/// LEDs, lamps like them and their images in mirrors are red lights: geometry tells them.
bool is_red_light(Origin origin) { return origin <= Origin::kReflection; }

void count(Tally& tally, const ViewScore& view, const std::string& where) {
  for (const LedScore& led : view.leds) {
    ++tally.asked;
    tally.found += led.found ? 1 : 0;
    tally.in_95 += led.in_95 ? 1 : 0;
    if (!led.found) tally.missed += where + led.cause + "\n";
  }
  for (const PointScore& point : view.points) {
    if (is_red_light(point.origin)) continue;
    tally.believed += where + std::string(bench::kOriginNames.at(static_cast<std::size_t>(point.origin))) + "\n";
  }
}

class Eye {
 public:
  ViewScore look(const RenderedFrame& rendered, const SimulatedWorld& world) {
    const Frame frame = frame_of(rendered);
    const bool packed = frame.format == PixelFormat::kMjpeg;
    const Picture picture = packed ? decoder_.decode(frame.data, frame.size).value() : picture_of(frame);
    const Detection detection = detector_.detect(picture, {});
    return bench::view_score(detection, detector_.candidates(), rendered.truth, world);
  }

 private:
  MjpegDecoder decoder_;
  LedDetector detector_{LedDetectorSettings{}};
};

Tally tally_of(PixelFormat format, std::uint64_t scenes) {
  Tally tally;
  Eye eye;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    SimulationSettings settings = clutter_settings(seed, {});
    settings.format = format;
    const SimulatedWorld world = SimulatedWorld::create(settings).value();
    PerSide<ViewScore> views;
    for (const Side side : kBothSides) {
      views[side] = eye.look(render(world, side, Duration{0}), world);
      count(tally, views[side], "seed " + std::to_string(seed) + " " + std::string(name(side)) + ": ");
    }
    LineModel model;
    model.calibration = settings.rig;
    model.rig = world.rig();
    tally.wrong_pairs += bench::pair_counts(model, views).others;
  }
  return tally;
}

void expect_solved(PixelFormat format) {
  const Tally tally = tally_of(format, 30);
  ASSERT_GT(tally.asked, 150) << "30 scenes of 3 or 4 LEDs in two views, some of them hidden";
  EXPECT_GE(tally.found, 0.96 * tally.asked) << tally.missed;  // the thousand scenes of the figure: 0.99
  EXPECT_GE(tally.in_95, 0.95 * tally.found);
  EXPECT_EQ(tally.believed, "");
  EXPECT_EQ(tally.wrong_pairs, 0);
}

TEST(ClutterScenesTest, LedsAreFoundAndNothingElseIsBelievedInYuyv) { expect_solved(PixelFormat::kYuyv); }

TEST(ClutterScenesTest, LedsAreFoundAndNothingElseIsBelievedInMjpeg) { expect_solved(PixelFormat::kMjpeg); }

}  // namespace
}  // namespace tripoint
