#include "line/pose/tag_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/diagonals.h"
#include "geometry/rigid_fit.h"
#include "line/pose/body_pose.h"
#include "line/pose/locate.h"
#include "line/pose/tilt.h"
#include "line/pose/whole_fit.h"

namespace tripoint {
namespace {

constexpr double kRunnerUp = 10.0;  // chi-square, as between LEDs that are alike
// Chi-square: what is stated as excluded by 5.5 deviations must be by 5.1.
constexpr double kExcluded = 30.0;
constexpr double kAlsoLikely = 26.0;
constexpr std::array<double, 2> kToOtherTilt{0.5, 1.0};  // where else a target is looked at
constexpr double kLeastWidth = 0.1;                      // of a triangle's length, as target files are asked for
constexpr double kSameTurn_rad = 1e-4;  // both starts came to one pose: far below any noise, far above the fit's end

using Located = FixedVector<LocatedPoint, kMaxImagePoints>;

/// Where the diagonals meet in a picture without distortion. The slopes are those of the picture as it is: distortion
/// changes them by parts in a thousand across a tag.
Result<ImagePoint> centre_in(std::span<const Pair> corners, Side side, const CameraModel& camera) {
  std::array<Vec2, kTagCorners> straight;
  std::array<Vec2, kTagCorners> places_px;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const RawPixel& at = corners[k].points[side].seen.at;
    const Result<NormalizedPoint> point = undistorted(camera, at);
    if (!point) return tl::make_unexpected(point.error());
    straight[k] = {point->x, point->y};
    places_px[k] = {at.u_px, at.v_px};
  }
  const Vec2 middle = diagonals_of(straight).at;
  const DiagonalCrossing crossing = diagonals_of(places_px);
  const auto by_corner = [&](std::size_t corner) -> Matrix2 {
    return crossing.by_corners.middleCols<2>(static_cast<Eigen::Index>(2 * (corner % kTagCorners)));
  };
  ImagePoint centre = corners[0].points[side].seen;
  centre.at = distorted(camera, {middle.x(), middle.y()});
  centre.covariance_px2 = Matrix2::Zero();
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const ImagePoint& corner = corners[k].points[side].seen;
    const Matrix2 together = by_corner(k) * corner.shared_with_next_px2 * by_corner(k + 1).transpose();
    centre.covariance_px2 +=
        by_corner(k) * corner.covariance_px2 * by_corner(k).transpose() + together + together.transpose();
  }
  return centre;
}

/// Four corners as one pair. Its timing is that of a corner: a tag moves as one.
Result<Pair> centre_of(std::span<const Pair> corners, const Rig& rig) {
  Pair centre = corners[0];
  for (const Side side : kBothSides) {
    const Result<ImagePoint> seen = centre_in(corners, side, rig.cameras[side]);
    if (!seen) return tl::make_unexpected(seen.error());
    centre.points[side].seen = *seen;
  }
  return centre;
}

Result<Located> located_centres(const Aligned& seen, const Pairs& pairs, const LineModel& model, Fit& fit) {
  Located centres;
  double squares_px2 = 0.0;
  for (std::size_t first = 0; first + kTagCorners <= pairs.pairs.size(); first += kTagCorners) {
    const Result<Pair> centre = centre_of({pairs.pairs.begin() + first, kTagCorners}, model.rig);
    if (!centre) return tl::make_unexpected(centre.error());
    const Result<LocatedPoint> at =
        located(*centre, model.target.points[place_of_tag(centre->id, model.target)], seen, model);
    if (!at) return tl::make_unexpected(at.error());
    squares_px2 += residual_square_px2(*at);
    fit.timing_sigma_mm = std::max(fit.timing_sigma_mm, at->moved_by_clocks_mm.norm());
    fit.points.push_back(measured_point(*centre, *at, model));
    centres.push_back(*at);
  }
  if (!centres.empty()) fit.residual_rms_px = std::sqrt(squares_px2 / static_cast<double>(centres.size()));
  return centres;
}

/// Nobody has seen a tag from behind.
bool shows_fronts(const Isometry3& rig_from_target, const Pairs& pairs, const LineModel& model) {
  return std::all_of(pairs.pairs.begin(), pairs.pairs.end(), [&](const Pair& pair) {
    const auto& corners_mm = model.target.tags[place_of_tag(pair.id, model.target)].corners_mm;
    const Vec3 front = rig_from_target.linear() * (corners_mm[1] - corners_mm[0]).cross(corners_mm[2] - corners_mm[1]);
    return std::all_of(kBothSides.begin(), kBothSides.end(), [&](Side side) {
      const Vec3 lens_mm = model.rig.camera_from_rig[side].inverse().translation();
      return front.dot(lens_mm - rig_from_target * corners_mm[0]) > 0.0;
    });
  });
}

struct Solved {
  std::optional<BodyPose> pose;
  Faults faults;
};

/// Of a flat target that may be tilted this way or the other.
struct Tilts {
  WholeFit best;
  std::optional<WholeFit> rival;  ///< far less likely; nothing when there is but one tilt
  Faults faults;                  ///< why none is believed
};

Isometry3 other_tilt(std::span<const LocatedPoint> corners, const Isometry3& rig_from_target) {
  FixedVector<Vec3, kMaxImagePoints> in_target_mm;
  for (const LocatedPoint& point : corners) in_target_mm.push_back(point.of.in_target_mm);
  return tilted_over(rig_from_target, {in_target_mm.begin(), in_target_mm.size()});
}

Tilts tilts_of(std::span<const LocatedPoint> corners, const LineModel& model) {
  const Isometry3 start = pose_of_widest_triangle(corners);
  const Result<WholeFit> one = whole_fit(corners, model, start);
  const Result<WholeFit> other = whole_fit(corners, model, other_tilt(corners, start));
  if (!one && !other) return {{}, std::nullopt, {Fault::kGeometryGate}};
  const bool first = !other || (one && one->chi2 <= other->chi2);
  const WholeFit& best = first ? *one : *other;
  if (best.chi2 > most_chi2(corners.size())) return {best, std::nullopt, {Fault::kGeometryGate}};
  if (!one || !other) return {best, std::nullopt, {Fault::kAmbiguous}};
  const WholeFit& rival = first ? *other : *one;
  if (turn_between_rad(best.rig_from_target, rival.rig_from_target) < kSameTurn_rad) return {best, std::nullopt, {}};
  if (rival.chi2 - best.chi2 < kRunnerUp) return {best, rival, {Fault::kAmbiguous}};
  return {best, rival, {}};
}

/// Turned by a share of the way to another pose, about the place that both have in common.
Isometry3 turned_towards(const Isometry3& from, const Isometry3& to, const Vec3& middle_in_target_mm, double share) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = Eigen::AngleAxisd(share * turn.angle(), turn.axis()) * from.linear();
  pose.translation() = from * middle_in_target_mm - pose.linear() * middle_in_target_mm;
  return pose;
}

Vec3 middle_of(std::span<const LocatedPoint> corners) {
  Vec3 middle_mm = Vec3::Zero();
  for (const LocatedPoint& corner : corners) middle_mm += corner.of.in_target_mm / static_cast<double>(corners.size());
  return middle_mm;
}

/// Between two tilts that nearly run into one the valley of likely poses is wider than a covariance says: half the way
/// to the other tilt, or there, a pose is nearly as likely as the best, and stated as excluded.
bool states_too_little(const BodyPose& pose, const WholeFit& best, std::span<const LocatedPoint> corners,
                       const LineModel& model) {
  const Isometry3 other = other_tilt(corners, best.rig_from_target);
  const Matrix3 stated_rad2 = (pose.in_output.noise + pose.in_output.shared).bottomRightCorner<3, 3>();
  const Eigen::LLT<Matrix3> stated(stated_rad2);
  return std::any_of(kToOtherTilt.begin(), kToOtherTilt.end(), [&](double share) {
    const Isometry3 there = turned_towards(best.rig_from_target, other, middle_of(corners), share);
    const Eigen::AngleAxisd turn(there.linear() * pose.rig_from_target.linear().transpose());
    const Vec3 turn_rad = model.output_from_rig.linear() * (turn.angle() * turn.axis());
    if (turn_rad.dot(stated.solve(turn_rad)) < kExcluded) return false;
    const Result<double> chi2 = whole_chi2(corners, model, there);
    return chi2 && *chi2 - best.chi2 < kAlsoLikely;
  });
}

/// The fit of `pose_of_body` starts at the likelier tilt, and must stay there.
Solved solved_by_corners(std::span<const LocatedPoint> corners, const LineModel& model) {
  const Tilts tilts = tilts_of(corners, model);
  if (!tilts.faults.empty()) return {std::nullopt, tilts.faults};
  const Isometry3& best = tilts.best.rig_from_target;
  const Result<BodyPose> pose = pose_of_body(corners, model, best);
  if (!pose) return {std::nullopt, {Fault::kGeometryGate}};
  const Matrix3 turn_covariance_rad2 = (pose->in_output.noise + pose->in_output.shared).bottomRightCorner<3, 3>();
  const double away_rad = turn_between_rad(best, pose->rig_from_target);
  const bool gone = away_rad > reach_of_tilt_rad(best, other_tilt(corners, best), turn_covariance_rad2);
  const bool gone_over =
      tilts.rival && turn_between_rad(tilts.rival->rig_from_target, pose->rig_from_target) < away_rad;
  if (gone || gone_over || states_too_little(*pose, tilts.best, corners, model))
    return {std::nullopt, {Fault::kAmbiguous}};
  return {*pose, {}};
}

/// Three of them say how the target is turned.
bool make_a_triangle(std::span<const LocatedPoint> centres) {
  if (centres.size() < 3) return false;
  FixedVector<Vec3, kMaxImagePoints> places_mm;
  double longest_mm = 0.0;
  for (const LocatedPoint& centre : centres) {
    for (const Vec3& place_mm : places_mm)
      longest_mm = std::max(longest_mm, (place_mm - centre.of.in_target_mm).norm());
    places_mm.push_back(centre.of.in_target_mm);
  }
  const auto [a, b, c] = widest_triangle({places_mm.begin(), places_mm.size()});
  const double twice_area_mm2 = (places_mm[b] - places_mm[a]).cross(places_mm[c] - places_mm[a]).norm();
  return twice_area_mm2 >= kLeastWidth * longest_mm * longest_mm;
}

Solved solved_by_centres(std::span<const LocatedPoint> centres, const LineModel& model) {
  if (!make_a_triangle(centres)) return {std::nullopt, {Fault::kNotSeenLeft, Fault::kNotSeenRight}};
  const Result<BodyPose> pose = pose_of_body(centres, model);
  if (!pose) return {std::nullopt, {Fault::kGeometryGate}};
  const Result<WholeFit> whole = whole_fit(centres, model, pose->rig_from_target);
  if (!whole || whole->chi2 > most_chi2(centres.size())) return {std::nullopt, {Fault::kGeometryGate}};
  return {*pose, {}};
}

}  // namespace

Fit pose_of_tags(const Aligned& seen, const Pairs& pairs, const LineModel& model) {
  Fit fit;
  if (pairs.pairs.empty()) return fit;
  const Result<Located> centres = located_centres(seen, pairs, model, fit);
  const bool by_centres = model.method == Method::kPaper;
  const Result<Located> points = by_centres ? centres : located_target(pairs, seen, model);
  if (!centres || !points) {
    fit.faults.insert(Fault::kGeometryGate);
    return fit;
  }
  const std::span<const LocatedPoint> all{points->begin(), points->size()};
  const Solved solved = by_centres ? solved_by_centres(all, model) : solved_by_corners(all, model);
  fit.faults.insert(solved.faults);
  if (!solved.pose) return fit;
  if (!shows_fronts(solved.pose->rig_from_target, pairs, model)) {
    fit.faults.insert(Fault::kGeometryGate);
    return fit;
  }
  fit.pose = solved.pose->in_output;
  fit.timing_sigma_mm = std::max(fit.timing_sigma_mm, solved.pose->timing_sigma_mm);
  fit.uncorrected_cost_mm = solved.pose->uncorrected_cost_mm;
  return fit;
}

}  // namespace tripoint
