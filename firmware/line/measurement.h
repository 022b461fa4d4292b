// The verdict of the line: a pose or the reasons why there is none, always with its time.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "line/observation.h"
#include "values/fixed_vector.h"
#include "values/forecast.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

/// Why there is no valid pose; the value is the bit of register 34.
enum class Fault : std::uint8_t {
  kNoCalibration = 0,
  kLeftCameraLost = 1,
  kRightCameraLost = 2,
  kNotSeenLeft = 3,
  kNotSeenRight = 4,
  kAmbiguous = 5,
  kEpipolarGate = 6,
  kGeometryGate = 7,
  kOutsideVolume = 8,
  kTimingBound = 9,
  kDecalibration = 10,
  kCalibrationDoesNotFit = 11,
  kInternal = 12,
};
inline constexpr std::array<std::string_view, 13> kFaultNames{
    "no_calibration", "left_camera_lost", "right_camera_lost", "not_seen_left",
    "not_seen_right", "ambiguous",        "epipolar_gate",     "geometry_gate",
    "outside_volume", "timing_bound",     "decalibration",     "calibration_does_not_fit",
    "internal"};

/// Something to look at although the pose stands; the value is the bit of register 35.
enum class Warning : std::uint8_t {
  kSaturatedSpot = 0,
  kWeakSpot = 1,
  kHighResidual = 2,
  kCalibrationOld = 3,
  kTemperature = 4,
  kFramesDropped = 5,
  kDiskNearlyFull = 6,
  kNoUniqueSerial = 7,
  kWarmUp = 8,
  kRefusedClients = 9,
  kResourceMissing = 10,
  kLightUnproved = 11,
};

/// A small set of enumerators, kept as the bits of a register.
template <typename E>
class BitSet16 {
 public:
  constexpr BitSet16() = default;
  constexpr BitSet16(std::initializer_list<E> members) {
    for (const E member : members) insert(member);
  }
  constexpr void insert(E member) { bits_ = static_cast<std::uint16_t>(bits_ | mask(member)); }
  constexpr void insert(BitSet16 members) { bits_ = static_cast<std::uint16_t>(bits_ | members.bits_); }
  [[nodiscard]] constexpr bool contains(E member) const { return (bits_ & mask(member)) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  [[nodiscard]] constexpr std::uint16_t bits() const { return bits_; }
  friend constexpr bool operator==(BitSet16, BitSet16) = default;

 private:
  static constexpr std::uint16_t mask(E member) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(member));
  }
  std::uint16_t bits_ = 0;
};
using Faults = BitSet16<Fault>;
using Warnings = BitSet16<Warning>;

/// One point of the target, or a spot that has no identity yet (id 0).
struct MeasuredPoint {
  int id = 0;
  Vec3 in_output_mm = Vec3::Zero();
  Matrix3 covariance_mm2 = Matrix3::Zero();  ///< noise and shared part together
  double residual_px = 0.0;                  ///< RMS of both pictures' reprojection errors
  PerSide<RawPixel> at;
  PerSide<double> peak_luma{0.0, 0.0};
  bool saturated = false;
  bool weak = false;
};

/// Output frame from target. Without a rotation only the upper left 3x3 (x, y, z) of the covariances counts.
struct TargetPose {
  Vec3 position_in_output_mm = Vec3::Zero();
  std::optional<Matrix3> output_from_target;  ///< rotation
  Matrix6 noise = Matrix6::Zero();            ///< x y z mm, rotation vector rad applied on the left
  Matrix6 shared = Matrix6::Zero();           ///< the calibration's part: never averages out
};

/// What time did to this measurement.
struct Timing {
  double skew_s = 0.0;                        ///< right minus left: how far apart the two newest pictures were exposed
  double skew_sigma_s = 0.0;                  ///< standard deviation of the offset between the stamps
  std::optional<double> uncorrected_cost_mm;  ///< of the skew, taken as none; absent without a target that moves
  double speed_mm_per_s = 0.0;                ///< 0 until two measurements exist
  bool settled = false;                       ///< speed under the limit, for pick points
};

struct Measurement {
  std::uint64_t sequence = 0;
  TimePoint exposed{};
  TimePoint exposure_began{};  ///< of the pictures that took part, of both cameras, the one that began first
  bool common_time = false;    ///< a new common time of both cameras was brought to a verdict: the heart beats
  Faults faults;
  Warnings warnings;
  Timing timing;
  FixedVector<MeasuredPoint, kMaxTargetPoints> points;
  std::optional<TargetPose> pose;  ///< only when no fault is set
  double residual_rms_px = 0.0;
  double epipolar_rms_px = 0.0;
  std::optional<double> side_length_error_mm;  ///< mean over the target's sides: measured less nominal
  std::optional<double> decalibration_mm;      ///< by which a turned camera misplaces the target, as far as it shows
  bool mount_watched = false;                  ///< the datum is seen where it belongs
  PerSide<ImageHealth> health;
  PerSide<std::uint16_t> spots{0, 0};
};

}  // namespace tripoint
