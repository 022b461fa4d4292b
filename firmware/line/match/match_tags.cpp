#include "line/match/match_tags.h"

#include <array>
#include <optional>

#include "line/match/epipolar.h"
#include "line/match/straight_corners.h"

namespace tripoint {
namespace {

using SeenPoints = FixedVector<AlignedPoint, kMaxImagePoints>;
/// Places in a picture's list of points, one for each corner.
using Corners = std::array<std::size_t, kTagCorners>;

struct FoundTag {
  std::optional<Corners> corners;  // all four of them
  bool twice = false;
};

FoundTag find_tag(const SeenPoints& points, int tag_id) {
  FoundTag found;
  Corners corners{};
  std::array<int, kTagCorners> count{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<PointLabel>& label = points[i].seen.label;
    if (!label || label->tag_id != tag_id) continue;
    const auto corner = static_cast<std::size_t>(label->corner);
    corners[corner] = i;
    if (++count[corner] > 1) found.twice = true;
  }
  if (count == std::array<int, kTagCorners>{1, 1, 1, 1}) found.corners = corners;
  return found;
}

MeasuredPixel whole_uncertainty(const AlignedPoint& point) {
  return {point.seen.at, point.seen.covariance_px2 + point.timing_px2};
}

/// Of one tag in one picture.
using TagPoints = std::array<AlignedPoint, kTagCorners>;

/// Nothing when a corner cannot be undistorted.
std::optional<TagPoints> straightened(const SeenPoints& points, const Corners& corners, const CameraModel& camera) {
  TagPoints tag;
  std::array<RawPixel, kTagCorners> seen;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    tag[k] = points[corners[k]];
    seen[k] = tag[k].seen.at;
  }
  const auto straight = straight_corners(camera, seen);
  if (!straight) return std::nullopt;
  for (std::size_t k = 0; k < kTagCorners; ++k) tag[k].seen.at = (*straight)[k];
  return tag;
}

struct TagPairs {
  std::array<Pair, kTagCorners> pairs;
  Faults faults;  ///< why they are none
};

TagPairs pairs_of(const Aligned& seen, const PerSide<Corners>& corners, int tag_id, const LineModel& model) {
  TagPairs tag;
  const auto left = straightened(seen.points.left, corners.left, model.rig.cameras.left);
  const auto right = straightened(seen.points.right, corners.right, model.rig.cameras.right);
  if (!left || !right) return {{}, {Fault::kGeometryGate}};
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const std::optional<EpipolarGate> gate =
        epipolar_gate(model, {whole_uncertainty((*left)[k]), whole_uncertainty((*right)[k])});
    if (!gate) return {{}, {Fault::kGeometryGate}};
    if (!gate->passed) return {{}, {Fault::kEpipolarGate}};
    tag.pairs[k] = {tag_id, {(*left)[k], (*right)[k]}, gate->distance_px, gate->sigma_px};
  }
  return tag;
}

/// What one picture shows the other one lacks.
Faults faults_of_nothing_shared(const PerSide<bool>& any) {
  Faults faults;
  if (!any.left || any.right) faults.insert(Fault::kNotSeenLeft);
  if (!any.right || any.left) faults.insert(Fault::kNotSeenRight);
  return faults;
}

}  // namespace

Pairs match_tags(const Aligned& seen, const LineModel& model) {
  Pairs matched;
  PerSide<bool> any{false, false};
  for (const TargetTag& tag : model.target.tags) {
    const PerSide<FoundTag> found{find_tag(seen.points.left, tag.id), find_tag(seen.points.right, tag.id)};
    if (found.left.twice || found.right.twice) matched.faults.insert(Fault::kAmbiguous);
    for (const Side side : kBothSides) any[side] = any[side] || found[side].corners.has_value();
    if (!found.left.corners || !found.right.corners) continue;
    const TagPairs one = pairs_of(seen, {*found.left.corners, *found.right.corners}, tag.id, model);
    matched.faults.insert(one.faults);
    if (!one.faults.empty()) continue;
    for (const Pair& pair : one.pairs) matched.pairs.push_back(pair);
  }
  if (!matched.pairs.empty() || !matched.faults.empty()) return matched;
  matched.faults = faults_of_nothing_shared(any);
  return matched;
}

}  // namespace tripoint
