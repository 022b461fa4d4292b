#include "line/pose/pose.h"

#include <cmath>

#include "line/pose/body_pose.h"
#include "line/pose/locate.h"
#include "line/pose/tag_pose.h"

namespace tripoint {
namespace {

TargetPoint point_of_target(int id, const Target& target) {
  for (const TargetPoint& point : target.points) {
    if (point.id == id) return point;
  }
  return {.id = id};
}

/// Of a target that is a single point.
BodyPose position_only(const LocatedPoint& at, const LineModel& model) {
  const Matrix3 rotation = model.output_from_rig.linear();
  BodyPose pose;
  pose.in_output.position_in_output_mm = model.output_from_rig * at.place.in_rig_mm;
  const double mounted_mm = at.of.uncertainty_mm / 2.0;
  pose.in_output.noise.topLeftCorner<3, 3>() =
      rotation * at.place.covariance_mm2 * rotation.transpose() + mounted_mm * mounted_mm * Matrix3::Identity();
  pose.in_output.shared.topLeftCorner<3, 3>() = shared_in_output_mm2(at, model);
  pose.timing_sigma_mm = at.moved_by_clocks_mm.norm();
  if (at.moved_by_skew_mm) pose.uncorrected_cost_mm = at.moved_by_skew_mm->norm();
  return pose;
}

using LocatedPoints = FixedVector<LocatedPoint, kMaxTargetPoints>;

/// Nothing unless all points of the target were identified.
Result<std::optional<BodyPose>> body_pose(const LocatedPoints& identified, const LineModel& model) {
  if (identified.empty() || identified.size() != model.target.points.size()) return std::optional<BodyPose>{};
  if (identified.size() == 1) return std::optional<BodyPose>{position_only(identified[0], model)};
  if (identified.size() == 2) return std::optional<BodyPose>{};
  const Result<BodyPose> pose = pose_of_body({identified.begin(), identified.size()}, model);
  if (!pose) return tl::make_unexpected(pose.error());
  return std::optional<BodyPose>{*pose};
}

}  // namespace

Fit pose_of_target(const Aligned& seen, const Pairs& pairs, const LineModel& model) {
  if (!model.target.tags.empty()) return pose_of_tags(seen, pairs, model);
  Fit fit;
  LocatedPoints identified;
  double squares_px2 = 0.0;
  for (const Pair& pair : pairs.pairs) {
    const Result<LocatedPoint> at = located(pair, point_of_target(pair.id, model.target), seen, model);
    if (!at) {
      fit.faults.insert(Fault::kGeometryGate);
      continue;
    }
    squares_px2 += residual_square_px2(*at);
    fit.points.push_back(measured_point(pair, *at, model));
    if (pair.id != 0) identified.push_back(*at);
  }
  if (!fit.points.empty()) fit.residual_rms_px = std::sqrt(squares_px2 / static_cast<double>(fit.points.size()));
  const Result<std::optional<BodyPose>> pose = body_pose(identified, model);
  if (!pose) fit.faults.insert(Fault::kGeometryGate);
  if (!pose || !*pose) return fit;
  fit.pose = (*pose)->in_output;
  fit.timing_sigma_mm = (*pose)->timing_sigma_mm;
  fit.uncorrected_cost_mm = (*pose)->uncorrected_cost_mm;
  return fit;
}

}  // namespace tripoint
