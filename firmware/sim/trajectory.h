// Where the simulated target is at a given time: closed forms, or a table read from a file.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "values/linear.h"
#include "values/result.h"
#include "values/time.h"

namespace tripoint {

/// A repeated motion. Its phase is the time since 1970 UTC modulo the period: whoever knows the UTC time of a pose
/// knows where the target truly was, without another channel.
struct Trajectory {
  Duration period{std::chrono::seconds{1}};
  /// Reference frame from target, mm, for a phase of 0 up to the period, in seconds.
  std::function<Isometry3(double phase_s)> reference_from_target;
};

/// Reference frame from target at a time since 1970 UTC.
Isometry3 target_pose_at(const Trajectory& trajectory, Duration since_1970);

/// The paper's line: from (-20, -50, 395) by (40, 100, 10) mm in 6 s, then back; constant speed.
Trajectory paper_linear();

/// The paper's circle: half a circle over the chord from (-68.5, 68, 385) to (-60.5, -93, 476) mm, in the plane of
/// the chord and the x axis, bulging to +x, in 6 s, then back; constant speed. The paper gives no radius: that it is
/// half a circle is an assumption.
Trajectory paper_circular();

/// Three rounds of the paper's circle, for cameras that are knocked in the second.
Trajectory three_circles();
inline constexpr double kRound_s = 12.0;

/// The tip of the paper's wheeled manipulator (Eq. 18 and 19, Table III): the base drives 1 m while the joints turn
/// from -180 and -90 to -45 and 45 degrees, links of 0.16 and 0.21 m, in 3 s, then back; constant speeds. The real path
/// is 1.5 m long; here it has a tenth of its size, upright in the plane z = 400 mm, centred on the z axis.
Trajectory scout();

/// 27 stations over the volume that both default cameras see, 2 s at each, 1 s from one to the next.
Trajectory static_volume();
inline constexpr double kStationHold_s = 2.0;
inline constexpr double kStationMove_s = 1.0;

/// The stations of static_volume(), mm in the reference frame, in the order in which they are visited.
std::vector<Vec3> volume_stations();

/// "paper-linear", "paper-circular", "scout", "static-volume" or "bumped-camera".
///
/// @return kOutOfRange for any other name
Result<Trajectory> scenario_trajectory(std::string_view name);

/// One row of a trajectory file.
struct TrajectorySample {
  double t_s = 0.0;
  Vec3 in_reference_mm = Vec3::Zero();
  Eigen::Quaterniond reference_from_target = Eigen::Quaterniond::Identity();
};

/// Linear in position, slerp in rotation; repeated with the period last time - first time, starting at phase 0 with
/// the first sample. A motion that does not end where it begins jumps there.
///
/// @return kMalformed when there are fewer than two samples or their times do not increase
Result<Trajectory> interpolated(std::vector<TrajectorySample> samples);

/// A CSV file with the header t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz (reference frame from target).
///
/// @return kCannotRead when the file is missing; kMalformed, with the line, when it is not such a table
Result<Trajectory> load_trajectory(const std::filesystem::path& path);

}  // namespace tripoint
