// Everything the line must know to turn image points into a verdict: swapped whole, between events.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/rig.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

enum class OutputFrame : std::uint16_t { kReference = 0, kLeftCamera = 1, kRobotBase = 2 };
enum class Method : std::uint8_t { kMaximumLikelihood, kPaper };

struct TargetPoint {
  int id = 1;
  Vec3 in_target_mm = Vec3::Zero();
  double uncertainty_mm = 0.05;               ///< k = 2
  std::optional<Vec3> facing = std::nullopt;  ///< unit length, where this one shines another way than the target
};
/// Where the corners lie in a tag of size 2: x right, y down. The order is that of the detector, counter-clockwise as a
/// camera sees them.
inline constexpr std::array<std::array<double, 2>, kTagCorners> kTagCornerPlaces{
    {{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}};

/// A square tag, in the target's frame.
struct TargetTag {
  int id = 0;
  /// In the order of the detector.
  std::array<Vec3, kTagCorners> corners_mm{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double uncertainty_mm = 0.05;  ///< k = 2, of each corner
};

struct Target {
  FixedVector<TargetPoint, kMaxTargetPoints> points;  ///< LEDs; of tags their centres, in the order of the tags
  FixedVector<TargetTag, kMaxTargetPoints> tags;      ///< none: the target is made of LEDs
  Vec3 facing = Vec3::UnitZ();                        ///< unit length, in the target's frame: where its LEDs shine
};

/// A target outside is a fault, not a measurement. Absent in `replay` without --config.
struct WorkingVolume {
  Vec3 min_mm = Vec3::Zero();
  Vec3 max_mm = Vec3::Zero();
  Isometry3 from_rig = Isometry3::Identity();  ///< its edges lie along the axes of this frame
};

/// A fixed LED by which the mount is watched: no part of the target, and outside the volume by its radius or more.
struct Datum {
  Vec3 in_rig_mm = Vec3::Zero();
  double uncertainty_mm = 0.0;  ///< k = 2, along each axis
  double radius_mm = 0.0;       ///< a light so near is taken for it
};

struct Limits {
  double epipolar_sigmas = 4.5;          ///< gate of a left-right pair
  double weak_chi2 = 10.83;              ///< residual above which warning 2 is set: chi2(1) at 0.1 %
  Duration camera_silence{100'000'000};  ///< no frame for so long: the camera counts as lost
  double timing_bound_mm = 1.0;          ///< standard deviation that time may contribute; above it fault 9
  double offset_prior_s = 0.010;         ///< standard deviation of the unknown offset between the cameras' stamps
  double min_angle_rad = 0.01;           ///< between the rays of a point
  double settled_mm_per_s = 5.0;         ///< slower than this for a while: settled
};

struct LineModel {
  StereoCalibration calibration;
  Rig rig;
  RigCovariance covariance = RigCovariance::Zero();
  bool calibrated = true;        ///< false: there is no calibration (fault 0), only what needs none is used
  bool calibration_fits = true;  ///< false: it belongs to other cameras or another picture size (fault 11)
  Isometry3 output_from_rig = Isometry3::Identity();
  /// How that follows the calibration: translation, mm, and rotation vector in the output frame's directions, rad.
  Eigen::Matrix<double, 6, 24> output_by_calibration = Eigen::Matrix<double, 6, 24>::Zero();
  Target target;
  std::optional<WorkingVolume> volume;
  std::optional<Datum> datum;
  Limits limits;
  Method method = Method::kMaximumLikelihood;
};

}  // namespace tripoint
