// What the detector and a stereo gate make of a cluttered scene, against the truth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/triangulation.h"
#include "line/detect/led_detector.h"
#include "line/model.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint::bench {

/// What stands where a point was detected.
enum class Origin : std::uint8_t { kLed, kRedLamp, kReflection, kOtherLight, kHotPixel, kThing };
inline constexpr std::array<std::string_view, 6> kOriginNames{"led",         "red_lamp",  "reflection",
                                                              "other_light", "hot_pixel", "thing"};

/// What an LED that is to be found has about it. Beside: another light of at least a tenth of its red lies closer than
/// three standard deviations of both cores together. Outshone: the other lights alone clip red where the LED is.
enum class Company : std::uint8_t { kAlone, kBeside, kOutshone };
inline constexpr std::array<std::string_view, 3> kCompanyNames{"alone", "beside", "outshone"};

/// An LED is to be found when it lies in the picture by more than three standard deviations of its core and at least
/// 90 % of its light is seen. It is found by a point within 1 px, or within three of the point's own stated deviations.
struct LedScore {
  int id = 0;
  RawPixel at;
  double peak = 0.0;  ///< times clip
  Company company = Company::kAlone;
  bool found = false;
  bool covered = false;    ///< found, and within three stated deviations (98.9 % of a true normal error)
  bool in_95 = false;      ///< found, and within the stated ellipse of 95 %
  double error_px = 0.0;   ///< of the found point
  double stated_px = 0.0;  ///< its own standard deviation, per axis
  std::string cause{};     ///< of a miss: the drop cause that came furthest, "off" for a kept one too far away
};

struct PointScore {
  RawPixel at;
  Origin origin = Origin::kThing;
  int led = 0;  ///< id, when it is one
  MeasuredPixel pixel;
};

struct ViewScore {
  std::vector<LedScore> leds;  ///< those to be found
  std::vector<PointScore> points;
};

/// One view of a world.
ViewScore view_score(const Detection& detection, const CandidateLog& candidates, const FrameTruth& truth,
                     const SimulatedWorld& world);

/// A unit that knows the cameras, the target and its places exactly, and the clocks to 0.1 ms, in a scene of clutter.
LineModel clutter_model(const SimulationSettings& scene);

/// Pairs of a left and a right point that pass the epipolar gate and lie 250 to 1000 mm away.
struct PairCounts {
  int leds = 0;        ///< both points are the same LED
  int ghosts = 0;      ///< two different LEDs
  int red_lights = 0;  ///< a red lamp or a reflection takes part, and nothing worse
  int others = 0;      ///< something that is no red light takes part
};
PairCounts pair_counts(const LineModel& model, const PerSide<ViewScore>& views);

}  // namespace tripoint::bench
