// A target among other lights as two cameras see it: points, not pictures, by the hundred thousand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/rig.h"
#include "values/linear.h"
#include "values/pixel.h"
#include "values/side.h"

namespace tripoint {

struct ViewedSpot {
  RawPixel at;
  int led = kNoLed;  ///< of the target's points; never that of an image in a mirror
  static constexpr int kNoLed = -1;
};

struct TargetView {
  PerSide<std::vector<ViewedSpot>> spots;  ///< in no order
  Isometry3 rig_from_target = Isometry3::Identity();
  bool whole = true;      ///< every LED is seen by both cameras
  bool mirrored = false;  ///< a mirror shows the target's image
};

struct ViewSettings {
  double sigma_px = 0.1;        ///< of each coordinate of a spot
  int most_others = 6;          ///< lights and stray spots beside the target
  std::size_t most_spots = 12;  ///< in a picture; the mirror may show more
  double hidden_share = 0.2;    ///< of views in which an LED is hidden, in one camera or in both
  double mirror_share = 0.2;    ///< of views with a mirror
  Vec3 middle_mm{0.0, 0.0, 420.0};
  Vec3 half_mm{60.0, 60.0, 120.0};  ///< the target's origin lies so far around the middle, at most
};

/// The same seed gives the same scene; at `at_s` the target has moved on, at up to 300 mm/s and 1 rad/s in each
/// direction, while the other lights and the mirror stay. At 0 the target is turned to the cameras by up to 40 degrees
/// each way and any angle about their axis, all of it in both pictures. Half of the other lights
/// are points in space, half lie anywhere in each picture.
///
/// @param leds_mm places of the LEDs, which shine along z
TargetView target_view(const Rig& rig, std::span<const Vec3> leds_mm, const ViewSettings& settings, std::uint64_t seed,
                       double at_s = 0.0);

}  // namespace tripoint
