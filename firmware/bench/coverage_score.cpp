#include "bench/coverage_score.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "bench/pose_error.h"
#include "bench/seen_tags.h"
#include "line/gate/gate.h"
#include "line/match/match.h"
#include "line/pose/pose.h"
#include "sim/default_rig.h"
#include "sim/target_view.h"

namespace tripoint::bench {
namespace {

// 95 % of chi-square with three and with six degrees of freedom.
constexpr double kMostOfPosition = 7.815;
constexpr double kMostOfPose = 12.592;

const std::array<Vec3, 1> kOne{Vec3(0.0, 0.0, 0.0)};
const std::array<Vec3, 3> kTriangle{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};
const std::array<Vec3, 4> kFour{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0),
                                Vec3(50.0, 20.0, 40.0)};
const std::array<Vec3, 3> kThreeTags{Vec3(-45.0, -10.0, 0.0), Vec3(40.0, -25.0, 0.0), Vec3(5.0, 50.0, 0.0)};
const std::array<CoveredTarget, 3> kLeds{
    {{"one LED", "one", kOne}, {"three LEDs", "three", kTriangle}, {"four LEDs", "four", kFour}}};
const std::array<CoveredTarget, 2> kTags{
    {{"one tag", "one_tag", kOne, 40.0}, {"three tags", "three_tags", kThreeTags, 30.0}}};
constexpr std::uint64_t kOfEdges = 0x9e3779b97f4a7c15;  // so that they are drawn apart from the scene
constexpr double kEdgeShare = 0.2;  // of a corner's standard deviation, that of the middle of an edge

/// A target to be believed, and what a camera sees of the one that was made.
struct View {
  Isometry3 rig_from_target = Isometry3::Identity();
  Aligned seen;
};

bool is_of_tags(const CoveredTarget& covered) { return covered.tag_mm > 0.0; }

/// Their fronts look along z, as LEDs shine in `target_view`: turned about x from where `add_tag` puts them.
Target tags_of(const CoveredTarget& covered, double target_mm) {
  Target target;
  for (const Vec3& centre_mm : covered.leds_mm) {
    add_tag(target, static_cast<int>(target.tags.size()), covered.tag_mm, centre_mm, 2.0 * target_mm);
  }
  for (TargetTag& tag : target.tags) std::swap(tag.corners_mm[0], tag.corners_mm[3]);
  for (TargetTag& tag : target.tags) std::swap(tag.corners_mm[1], tag.corners_mm[2]);
  return target;
}

std::vector<Vec3> corners_of(const Target& target) {
  std::vector<Vec3> corners_mm;
  for (const TargetTag& tag : target.tags) {
    corners_mm.insert(corners_mm.end(), tag.corners_mm.begin(), tag.corners_mm.end());
  }
  return corners_mm;
}

struct Sums {
  int inside = 0;
  int axes = 0;
  int axes_inside = 0;
  double squares_mm2 = 0.0;
  double squares_rad2 = 0.0;
};

void add(Sums& sums, const TargetPose& pose, const Isometry3& truth) {
  const PoseError off = pose_error(pose, truth);
  const Matrix6 spread = pose.noise + pose.shared;
  sums.inside += off.chi2 <= (off.size == 6 ? kMostOfPose : kMostOfPosition) ? 1 : 0;
  for (Eigen::Index axis = 0; axis < off.size; ++axis) {
    ++sums.axes;
    sums.axes_inside += off.error[axis] * off.error[axis] <= 4.0 * spread(axis, axis) ? 1 : 0;
  }
  sums.squares_mm2 += off.error.head<3>().squaredNorm();
  sums.squares_rad2 += off.error.tail<3>().squaredNorm();
}

ViewSettings alone(double sigma_px) {
  return {.sigma_px = sigma_px,
          .most_others = 0,
          .hidden_share = 0.0,
          .mirror_share = 0.0,
          .middle_mm = {0.0, 0.0, 400.0},
          .half_mm = {150.0, 150.0, 100.0}};
}

View view_of_leds(const Rig& rig, const std::vector<Vec3>& made_mm, const ErrorSources& sources, std::uint64_t seed) {
  const TargetView view = target_view(rig, made_mm, alone(sources.spot_px), seed);
  return {view.rig_from_target, as_seen(view, sources.spot_px)};
}

/// @param made  the tags as they were made
View view_of_tags(const Rig& rig, const Target& made, const ErrorSources& sources, std::uint64_t seed) {
  LineModel truth;
  truth.rig = rig;
  truth.target = made;
  std::mt19937_64 random(seed + kOfEdges);
  View view{target_view(rig, corners_of(made), alone(0.0), seed).rig_from_target, {}};
  view.seen.due = view.seen.common_time = true;
  for (const Side side : kBothSides) {
    Observation picture;
    picture.side = side;
    add_tags(picture, truth, view.rig_from_target, {kEdgeShare * sources.spot_px, sources.spot_px}, random);
    for (const ImagePoint& point : picture.points)
      view.seen.points[side].push_back({point, std::nullopt, Matrix2::Zero()});
  }
  return view;
}

/// What a unit believes and what it sees.
struct Drawn {
  LineModel believed;
  View view;
};

Drawn drawn(const CoveredTarget& covered, const ErringUnits& units, const ErrorSources& sources, std::uint64_t seed) {
  const Rig rig = rig_of(default_rig()).value();
  std::mt19937_64 random(~seed);
  LineModel believed = units.model(covered.leds_mm, random);
  if (!is_of_tags(covered)) {
    return {believed, view_of_leds(rig, units.target(covered.leds_mm, random), sources, seed)};
  }
  believed.target = tags_of(covered, sources.target_mm);
  Target made = believed.target;
  const std::vector<Vec3> corners_mm = units.target(corners_of(made), random);
  for (std::size_t i = 0; i < corners_mm.size(); ++i) {
    made.tags[i / kTagCorners].corners_mm[i % kTagCorners] = corners_mm[i];
  }
  return {believed, view_of_tags(rig, made, sources, seed)};
}

}  // namespace

std::span<const CoveredTarget> covered_leds() { return kLeds; }
std::span<const CoveredTarget> covered_tags() { return kTags; }

CoverageScore coverage_score(const CoveredTarget& target, const ErrorSources& sources, std::uint64_t first_seed,
                             int views) {
  const ErringUnits units(default_rig(), sources);
  CoverageScore score;
  Sums sums;
  for (; score.views < views; ++score.views) {
    const auto [model, view] = drawn(target, units, sources, first_seed + static_cast<std::uint64_t>(score.views));
    const Pairs pairs = match(view.seen, model);
    const Measurement measured = gate(view.seen, pairs, pose_of_target(view.seen, pairs, model), model);
    if (!measured.pose) continue;
    ++score.poses;
    add(sums, *measured.pose, view.rig_from_target);
  }
  if (score.poses == 0) return score;
  score.inside_share = 1.0 * sums.inside / score.poses;
  score.axes_inside_share = 1.0 * sums.axes_inside / sums.axes;
  score.position_rms_mm = std::sqrt(sums.squares_mm2 / score.poses);
  score.orientation_rms_deg = std::sqrt(sums.squares_rad2 / score.poses) * 180.0 / std::numbers::pi;
  return score;
}

}  // namespace tripoint::bench
