// Two free-running cameras that look at points moving on a closed-form path: observations without pictures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "geometry/camera_model.h"
#include "geometry/rig.h"
#include "line/model.h"
#include "line/observation.h"
#include "values/linear.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint::testing {

/// 640x480, 628 px, 100 mm apart, each toed in by 5 degrees, with the distortion of a webcam.
inline StereoCalibration webcam_calibration() {
  StereoCalibration calibration;
  calibration.cameras.left = {{640, 480}, {628.0, 628.6}, {322.3, 237.8}, {-0.30, 0.10, 5e-4, -3e-4, 0.0}};
  calibration.cameras.right = {{640, 480}, {630.0, 629.5}, {318.1, 241.2}, {-0.29, 0.09, -4e-4, 2e-4, 0.0}};
  calibration.right_from_left = Eigen::Translation3d(-99.6, 0.2, 8.7) *
                                Eigen::AngleAxisd(10.0 * M_PI / 180.0, Vec3(0.04, 0.99, 0.07).normalized());
  return calibration;
}

inline LineModel webcam_model() {
  LineModel model;
  model.calibration = webcam_calibration();
  model.rig = *rig_of(model.calibration);
  model.target.points.push_back({.id = 1, .in_target_mm = Vec3::Zero(), .uncertainty_mm = 0.0});  // the origin itself
  model.volume = WorkingVolume{{-150.0, -150.0, 250.0}, {150.0, 150.0, 600.0}};
  model.limits.offset_prior_s = 1e-4;
  return model;
}

/// The right camera stands turned about its centre; the left one stays where it is in the reference frame of before.
inline LineModel with_right_camera_turned(const LineModel& model, const Vec3& turn_rad) {
  LineModel turned = model;
  turned.calibration.right_from_left.prerotate(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.stableNormalized()));
  turned.rig = *rig_of(turned.calibration);
  const Isometry3 left_stays = turned.rig.camera_from_rig.left.inverse() * model.rig.camera_from_rig.left;
  for (const Side side : kBothSides) turned.rig.camera_from_rig[side] = turned.rig.camera_from_rig[side] * left_stays;
  return turned;
}

inline std::shared_ptr<const LineModel> shared_model(const LineModel& model) {
  return std::make_shared<const LineModel>(model);
}

using Path = std::function<Vec3(double time_s)>;  // in the reference frame, mm

struct CameraTiming {
  double period_s = 1.0 / 30.0;
  double phase_s = 0.0;
  double jitter_s = 0.0;  // RMS of the stamps
  double drop_share = 0.0;
  double latency_s = 0.010;  // last row to arrival
};

struct Shooting {
  PerSide<CameraTiming> timing;
  double line_time_s = 0.0;
  double noise_px = 0.05;
  double duration_s = 10.0;
  std::uint32_t seed = 1;
};

/// Where a point appears in one camera, and when: with a rolling shutter its row decides.
inline RawPixel pixel_of(const LineModel& model, Side side, const Path& path, double frame_s, double line_time_s) {
  RawPixel pixel;
  for (int pass = 0; pass < (line_time_s > 0.0 ? 6 : 1); ++pass) {
    const Vec3 point = path(frame_s + pixel.v_px * line_time_s);
    pixel = *projected(model.rig.cameras[side], model.rig.camera_from_rig[side] * point);
  }
  return pixel;
}

inline ImagePoint spot_at(const RawPixel& pixel, double sigma_px) {
  ImagePoint point;
  point.at = pixel;
  point.covariance_px2 = sigma_px * sigma_px * Matrix2::Identity();
  point.amplitude = 100.0;
  return point;
}

inline Observation picture(Side side, std::uint32_t frame, double exposed_s) {
  Observation seen;
  seen.side = side;
  seen.frame = frame;
  seen.exposed = TimePoint{duration_from_seconds(exposed_s)};
  seen.arrived = seen.exposed + duration_from_seconds(0.010);
  return seen;
}

/// All observations of both cameras in the order of their arrival.
inline std::vector<Event> shot(const LineModel& model, const std::vector<Path>& paths, const Shooting& shooting) {
  std::mt19937_64 random(shooting.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<Observation> seen;
  for (const Side side : kBothSides) {
    const CameraTiming& timing = shooting.timing[side];
    for (std::uint32_t frame = 0;; ++frame) {
      const double exposed_s = 1.0 + timing.phase_s + frame * timing.period_s;
      if (exposed_s > 1.0 + shooting.duration_s) break;
      if (uniform(random) < timing.drop_share) continue;
      Observation one = picture(side, frame, exposed_s + timing.jitter_s * normal(random));
      one.arrived = TimePoint{duration_from_seconds(exposed_s + 480.0 * shooting.line_time_s + timing.latency_s)};
      one.line_time = duration_from_seconds(shooting.line_time_s);
      for (const Path& path : paths) {
        RawPixel pixel = pixel_of(model, side, path, exposed_s, shooting.line_time_s);
        pixel.u_px += shooting.noise_px * normal(random);
        pixel.v_px += shooting.noise_px * normal(random);
        one.points.push_back(spot_at(pixel, std::max(shooting.noise_px, 0.01)));
      }
      seen.push_back(one);
    }
  }
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.arrived < b.arrived; });
  return {seen.begin(), seen.end()};
}

inline Path at_rest(const Vec3& where) {
  return [where](double) { return where; };
}

/// A circle of 60 mm in a tilted plane about (0, 0, 400) mm at a constant speed.
inline Path circle(double speed_mm_per_s) {
  return [speed_mm_per_s](double time_s) -> Vec3 {
    const double angle = speed_mm_per_s / 60.0 * time_s;
    return {60.0 * std::cos(angle), 55.0 * std::sin(angle), 400.0 + 25.0 * std::sin(angle)};
  };
}

}  // namespace tripoint::testing
