#include "sim/trajectory.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace tripoint {
namespace {

constexpr double kPaperMove_s = 6.0;

/// Half a turn about x: the target's +z side, where its LEDs shine, looks at the cameras.
Isometry3 facing_the_cameras(const Vec3& in_reference_mm) {
  Isometry3 pose = Isometry3::Identity();
  pose.translation() = in_reference_mm;
  pose.linear() = Vec3(1.0, -1.0, -1.0).asDiagonal();
  return pose;
}

/// 0 to 1 during the first move, back to 0 during the second.
double there_and_back(double phase_s, double move_s) {
  return phase_s < move_s ? phase_s / move_s : 2.0 - phase_s / move_s;
}

/// Least-jerk move from 0 to 1: begins and ends at rest, without acceleration.
double smooth_step(double s) { return s * s * s * (10.0 + s * (-15.0 + 6.0 * s)); }

Isometry3 pose_on_tour(const std::vector<Vec3>& stations, double phase_s) {
  constexpr double kStay_s = kStationHold_s + kStationMove_s;
  const auto last = static_cast<double>(stations.size() - 1);
  const auto here = static_cast<std::size_t>(std::clamp(std::floor(phase_s / kStay_s), 0.0, last));
  const std::size_t next = (here + 1) % stations.size();
  const double moving_s = phase_s - static_cast<double>(here) * kStay_s - kStationHold_s;
  const double share = smooth_step(std::clamp(moving_s / kStationMove_s, 0.0, 1.0));
  return facing_the_cameras(stations[here] + share * (stations[next] - stations[here]));
}

}  // namespace

Isometry3 target_pose_at(const Trajectory& trajectory, Duration since_1970) {
  const Duration rest = since_1970 % trajectory.period;
  const Duration phase = rest < Duration::zero() ? rest + trajectory.period : rest;
  return trajectory.reference_from_target(seconds(phase));
}

Trajectory paper_linear() {
  return {.period = duration_from_seconds(2.0 * kPaperMove_s), .reference_from_target = [](double phase_s) {
            const Vec3 start(-20.0, -50.0, 395.0);
            const Vec3 way(40.0, 100.0, 10.0);
            return facing_the_cameras(start + there_and_back(phase_s, kPaperMove_s) * way);
          }};
}

Trajectory paper_circular() {
  return {.period = duration_from_seconds(2.0 * kPaperMove_s), .reference_from_target = [](double phase_s) {
            const Vec3 first(-68.5, 68.0, 385.0);
            const Vec3 last(-60.5, -93.0, 476.0);
            const Vec3 along = (last - first).normalized();
            const Vec3 bulge = (Vec3::UnitX() - along.x() * along).normalized();
            const double radius_mm = (last - first).norm() / 2.0;
            const double angle_rad = std::numbers::pi * there_and_back(phase_s, kPaperMove_s);
            return facing_the_cameras((first + last) / 2.0 - radius_mm * std::cos(angle_rad) * along +
                                      radius_mm * std::sin(angle_rad) * bulge);
          }};
}

Trajectory scout() {
  constexpr double kMove_s = 3.0;
  return {.period = duration_from_seconds(2.0 * kMove_s), .reference_from_target = [](double phase_s) {
            constexpr double kPi = std::numbers::pi;
            constexpr double kUpperLink_m = 0.16;
            constexpr double kForeLink_m = 0.21;
            constexpr double kTenthInMm = 100.0;    // a metre of the robot
            const Vec2 middle_m(0.58157, 0.04843);  // of the straight line from the first tip to the last
            const double share = there_and_back(phase_s, kMove_s);
            const double upper_rad = -kPi + share * 0.75 * kPi;
            const double fore_rad = upper_rad - kPi / 2.0 + share * 0.75 * kPi;
            const Vec2 tip_m(share + kUpperLink_m * std::cos(upper_rad) + kForeLink_m * std::cos(fore_rad),
                             kUpperLink_m * std::sin(upper_rad) + kForeLink_m * std::sin(fore_rad));
            const Vec2 placed_mm = kTenthInMm * (tip_m - middle_m);
            return facing_the_cameras({placed_mm.x(), -placed_mm.y(), 400.0});  // y points down
          }};
}

std::vector<Vec3> volume_stations() {
  std::vector<Vec3> stations;
  double x_sign = 1.0;
  double y_sign = 1.0;
  for (const double z_mm : {330.0, 400.0, 470.0}) {  // to and fro, so that every move but the last is short
    for (const double y_mm : {-60.0, 0.0, 60.0}) {
      for (const double x_mm : {-80.0, 0.0, 80.0}) stations.emplace_back(x_sign * x_mm, y_sign * y_mm, z_mm);
      x_sign = -x_sign;
    }
    y_sign = -y_sign;
  }
  return stations;
}

Trajectory static_volume() {
  std::vector<Vec3> stations = volume_stations();
  const double period_s = static_cast<double>(stations.size()) * (kStationHold_s + kStationMove_s);
  return {.period = duration_from_seconds(period_s),
          .reference_from_target = [stations = std::move(stations)](double phase_s) {
            return pose_on_tour(stations, phase_s);
          }};
}

Trajectory three_circles() {
  Trajectory rounds = paper_circular();
  rounds.period *= 3;
  rounds.reference_from_target = [once = rounds.reference_from_target](double phase_s) {
    return once(std::fmod(phase_s, kRound_s));
  };
  return rounds;
}

Result<Trajectory> scenario_trajectory(std::string_view name) {
  if (name == "paper-linear") return paper_linear();
  if (name == "paper-circular") return paper_circular();
  if (name == "scout") return scout();
  if (name == "static-volume") return static_volume();
  if (name == "bumped-camera") return three_circles();
  return failure(ErrorCode::kOutOfRange,
                 "scenario \"" + std::string(name) +
                     "\": must be paper-linear, paper-circular, scout, static-volume or bumped-camera");
}

Result<Trajectory> interpolated(std::vector<TrajectorySample> samples) {
  if (samples.size() < 2) return failure(ErrorCode::kMalformed, "a trajectory needs at least two samples");
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!(samples[i].t_s > samples[i - 1].t_s)) {
      return failure(ErrorCode::kMalformed, "trajectory sample " + std::to_string(i + 1) + ": t_s must increase");
    }
  }
  const Duration period = duration_from_seconds(samples.back().t_s - samples.front().t_s);
  return Trajectory{
      .period = period, .reference_from_target = [samples = std::move(samples)](double phase_s) {
        const double t_s = samples.front().t_s + phase_s;
        const auto after = std::upper_bound(samples.begin() + 1, samples.end() - 1, t_s,
                                            [](double t, const TrajectorySample& sample) { return t < sample.t_s; });
        const TrajectorySample& a = *(after - 1);
        const double share = std::clamp((t_s - a.t_s) / (after->t_s - a.t_s), 0.0, 1.0);
        Isometry3 pose = Isometry3::Identity();
        pose.translation() = a.in_reference_mm + share * (after->in_reference_mm - a.in_reference_mm);
        pose.linear() = a.reference_from_target.slerp(share, after->reference_from_target).toRotationMatrix();
        return pose;
      }};
}

}  // namespace tripoint
