// A target in front of cameras that may have been knocked, without noise.
#pragma once

#include <array>

#include "bench/erring_units.h"
#include "sim/default_rig.h"
#include "sim/target_view.h"

namespace tripoint::testing {

inline const std::array<Vec3, 3> kWatchedLeds{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};
inline constexpr double kSpot_px = 0.05;
inline constexpr double kPlace_mm = 0.025;  // of an LED in the target, standard deviation
inline const ViewSettings kAlone{.sigma_px = 0.0, .most_others = 0, .hidden_share = 0.0, .mirror_share = 0.0};

inline LineModel watched_model(const StereoCalibration& calibration = default_rig()) {
  return bench::model_of(kWatchedLeds, calibration, RigCovariance::Zero(), kPlace_mm);
}

/// The default rig after a turn of the right camera about its own axes.
inline StereoCalibration knocked_rig(const Vec3& turn_rad) {
  StereoCalibration rig = default_rig();
  rig.right_from_left.prerotate(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.stableNormalized()));
  return rig;
}

/// @param leds_mm as the target was made
inline TargetView view_by(const StereoCalibration& cameras, std::uint64_t scene,
                          std::span<const Vec3> leds_mm = kWatchedLeds) {
  return target_view(rig_of(cameras).value(), leds_mm, kAlone, scene);
}

}  // namespace tripoint::testing
