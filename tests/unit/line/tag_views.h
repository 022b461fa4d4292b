// Tags before two cameras, as the line sees them.
#pragma once

#include <random>
#include <vector>

#include "bench/seen_tags.h"
#include "line/line.h"
#include "synthetic_cameras.h"
#include "verdicts.h"

namespace tripoint::testing {

inline constexpr double kSigma_px = 0.02;  // of an edge's middle
inline constexpr int kViews = 200;

inline Isometry3 tilted(const Vec3& place_mm, double tilt_rad) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(tilt_rad, Vec3(0.6, 0.8, 0.0)) * Eigen::AngleAxisd(0.3, Vec3::UnitZ())).toRotationMatrix();
  pose.translation() = place_mm;
  return pose;
}
inline const Isometry3 kPose = tilted({15.0, -20.0, 410.0}, 0.5);

inline LineModel tag_model(int tags, double size_mm = 30.0) {
  LineModel model = webcam_model();
  model.target = {};
  const std::vector<Vec3> places_mm{{-45.0, -10.0, 0.0}, {40.0, -25.0, 0.0}, {5.0, 50.0, 0.0}};
  for (int i = 0; i < tags; ++i) bench::add_tag(model.target, 7 * i, size_mm, places_mm[static_cast<std::size_t>(i)]);
  return model;
}

struct Shown {
  PerSide<LineModel> model;  // whose tags each camera sees
  Isometry3 pose = kPose;
  double sigma_px = kSigma_px;
  int views = kViews;
};

inline std::vector<Measurement> seen(const LineModel& believed, const Shown& shown) {
  std::mt19937_64 random(11);
  std::vector<Event> events;
  for (int view = 0; view < shown.views; ++view) {
    for (const Side side : kBothSides) {
      Observation one = picture(side, static_cast<std::uint32_t>(view), 1.0 + view / 30.0);
      bench::add_tags(one, shown.model[side], shown.pose, {.edge_px = shown.sigma_px}, random);
      events.emplace_back(one);
    }
  }
  return testing::verdicts(believed, events);
}

inline std::vector<Measurement> seen(const LineModel& model) { return seen(model, {.model = {model, model}}); }

inline Eigen::Matrix<double, 6, 1> error_of(const TargetPose& pose, const Isometry3& truth) {
  const Eigen::AngleAxisd turn(*pose.output_from_target * truth.linear().transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << pose.position_in_output_mm - truth.translation(), turn.angle() * turn.axis();
  return error;
}

}  // namespace tripoint::testing
