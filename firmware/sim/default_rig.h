// The cameras that the simulation has when nobody names others.
#pragma once

#include <string_view>

#include "geometry/rig.h"
#include "values/side.h"

namespace tripoint {

/// Two wide-angle webcams 100 mm apart, toed in by 10 degrees together, with distortion. Other sizes see the same
/// scene: scaled by the width, and cut above and below where the shape differs.
StereoCalibration default_rig(ImageSize size = {.width_px = 640, .height_px = 480});

/// The serial number that a simulated camera reports.
constexpr std::string_view simulated_serial(Side side) { return side == Side::kLeft ? "SIM-LEFT" : "SIM-RIGHT"; }

}  // namespace tripoint
