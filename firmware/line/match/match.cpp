#include "line/match/match.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/triangulation.h"
#include "line/match/datum.h"
#include "line/match/epipolar.h"
#include "line/match/identify.h"
#include "line/match/likeness.h"
#include "line/match/match_tags.h"

namespace tripoint {
namespace {

struct DepthRange {
  double min_mm = 0.0;
  double max_mm = std::numeric_limits<double>::infinity();
};

/// Depths in the reference frame that the working volume's corners span.
DepthRange depth_range(const LineModel& model) {
  if (!model.volume) return {};
  const Isometry3 rig_from_volume = model.volume->from_rig.inverse();
  DepthRange range{std::numeric_limits<double>::infinity(), 0.0};
  for (int corner = 0; corner < 8; ++corner) {
    const auto pick = [&](int axis) {
      return (corner >> axis) % 2 == 0 ? model.volume->min_mm[axis] : model.volume->max_mm[axis];
    };
    const double depth_mm = (rig_from_volume * Vec3{pick(0), pick(1), pick(2)}).z();
    range.min_mm = std::min(range.min_mm, depth_mm);
    range.max_mm = std::max(range.max_mm, depth_mm);
  }
  return range;
}

MeasuredPixel whole_uncertainty(const AlignedPoint& point) {
  return {point.seen.at, point.seen.covariance_px2 + point.timing_px2};
}

PerSide<MeasuredPixel> whole_uncertainty(const AlignedPoint& left, const AlignedPoint& right) {
  return {whole_uncertainty(left), whole_uncertainty(right)};
}

/// Two that blink as different LEDs are no pair, wherever they are.
bool same_led(const ImagePoint& left, const ImagePoint& right) {
  return left.led == 0 || right.led == 0 || left.led == right.led;
}

/// Two points inside the epipolar gate, whose rays meet at a depth of the working volume.
struct Candidate {
  PerSide<std::size_t> index{0, 0};
  EpipolarGate gate;
  TriangulatedPoint point;
  bool alike = true;
};

struct Candidates {
  FixedVector<Candidate, kMaxPlacedPairs> pairs;
  PerSide<std::array<int, kMaxMatchedSpots>> partners{};
  Faults refused;
};

Candidates candidates(const Aligned& seen, const LineModel& model) {
  Candidates found;
  const DepthRange range = depth_range(model);
  for (std::size_t i = 0; i < seen.points.left.size(); ++i) {
    for (std::size_t j = 0; j < seen.points.right.size(); ++j) {
      if (!same_led(seen.points.left[i].seen, seen.points.right[j].seen)) continue;
      const PerSide<MeasuredPixel> pixels = whole_uncertainty(seen.points.left[i], seen.points.right[j]);
      const std::optional<EpipolarGate> gate = epipolar_gate(model, pixels);
      if (!gate || !gate->passed) continue;
      const Result<TriangulatedPoint> point = triangulated(model.rig, pixels, model.limits.min_angle_rad);
      if (!point) {
        found.refused.insert(Fault::kGeometryGate);
        continue;
      }
      const double depth_mm = point->in_rig_mm.z();
      if (depth_mm < range.min_mm || depth_mm > range.max_mm) {
        found.refused.insert(Fault::kOutsideVolume);
        continue;
      }
      const bool is_alike = alike(seen.points.left[i].seen, seen.points.right[j].seen);
      if (!is_alike) found.refused.insert(Fault::kGeometryGate);
      found.pairs.push_back({{i, j}, *gate, *point, is_alike});
      ++found.partners.left[i];
      ++found.partners.right[j];
    }
  }
  return found;
}

/// Of all reasons the one of the pair that came furthest.
Faults why_none(Faults refused) {
  for (const Fault reason : {Fault::kOutsideVolume, Fault::kGeometryGate}) {
    if (refused.contains(reason)) return {reason};
  }
  return {Fault::kEpipolarGate};
}

Pair pair_of(const Candidate& candidate, const Aligned& seen, int id) {
  const PerSide<std::size_t>& at = candidate.index;
  return {id,
          {seen.points.left[at.left], seen.points.right[at.right]},
          candidate.gate.distance_px,
          candidate.gate.sigma_px};
}

/// Two that are not alike are believed by nobody, but they may be the true pair: neither has another partner then.
Pairs unique_pairs(const Candidates& found, const Aligned& seen) {
  Pairs unique;
  bool any = false;
  for (const Candidate& candidate : found.pairs) {
    if (!candidate.alike) continue;
    any = true;
    const PerSide<std::size_t>& at = candidate.index;
    if (found.partners.left[at.left] == 1 && found.partners.right[at.right] == 1) {
      unique.pairs.push_back(pair_of(candidate, seen, 0));
    } else {
      unique.faults.insert(Fault::kAmbiguous);
    }
  }
  if (!any) unique.faults.insert(why_none(found.refused));
  return unique;
}

/// Those that are known by their blinking.
Pairs by_blinking(Pairs unique) {
  for (Pair& pair : unique.pairs) {
    const std::uint16_t led = pair.points.left.seen.led;
    if (led == pair.points.right.seen.led) pair.id = led;
  }
  return unique;
}

/// Of a target with a single point: the only pair.
Pairs alone(Pairs unique, const Target& target) {
  if (unique.pairs.size() == 1 && unique.faults.empty()) {
    unique.pairs[0].id = target.points[0].id;
  } else if (!unique.pairs.empty()) {
    unique.faults.insert(Fault::kAmbiguous);
  }
  return unique;
}

PlacedPair placed(const Candidate& candidate, const Aligned& seen, const LineModel& model) {
  const PerSide<std::size_t>& at = candidate.index;
  const PerSide<MeasuredPixel> pixels = whole_uncertainty(seen.points.left[at.left], seen.points.right[at.right]);
  PlacedPair pair{.index = at,
                  .alike = candidate.alike,
                  .led = std::max(seen.points.left[at.left].seen.led, seen.points.right[at.right].seen.led),
                  .in_rig_mm = candidate.point.in_rig_mm,
                  .covariance_mm2 = candidate.point.covariance_mm2,
                  .epipolar_px = candidate.gate.distance_px,
                  .epipolar_variance_px2 = candidate.gate.noise_px2};
  if (model.covariance.isZero(0.0)) return pair;
  pair.place_by_calibration = calibration_jacobian(model.calibration, pixels);
  pair.epipolar_by_calibration = epipolar_calibration_gradient(model.calibration, {pixels.left.at, pixels.right.at})
                                     .value_or(RigParameters::Zero());
  return pair;
}

Fault fault_of(IdentityVerdict verdict) {
  return verdict == IdentityVerdict::kAmbiguous ? Fault::kAmbiguous : Fault::kGeometryGate;
}

/// All points of a target of three or more, or else what is seen, without identity and with the reason.
Pairs identified(const Candidates& found, const Aligned& seen, const LineModel& model) {
  FixedVector<PlacedPair, kMaxPlacedPairs> pairs;
  for (const Candidate& candidate : found.pairs) pairs.push_back(placed(candidate, seen, model));
  const Identification identity = identify({pairs.begin(), pairs.size()}, model);
  const auto& points = model.target.points;
  if (identity.verdict != IdentityVerdict::kUnique) {
    Pairs unique = by_blinking(unique_pairs(found, seen));
    const bool few = seen.points.left.size() < points.size() || seen.points.right.size() < points.size();
    if (seen.points.left.size() < points.size()) unique.faults.insert(Fault::kNotSeenLeft);
    if (seen.points.right.size() < points.size()) unique.faults.insert(Fault::kNotSeenRight);
    if (!few) unique.faults.insert(fault_of(identity.verdict));
    return unique;
  }
  Pairs target;
  for (std::size_t i = 0; i < points.size(); ++i) {
    target.pairs.push_back(pair_of(found.pairs[identity.best.pair_of_point[i]], seen, points[i].id));
  }
  return target;
}

/// Two points give points, but which is which nobody knows.
Pairs unidentified(Pairs unique) {
  if (!unique.pairs.empty()) unique.faults.insert(Fault::kAmbiguous);
  return unique;
}

/// A side without points, unless align already said why it has none.
bool not_seen(const Aligned& seen, Side side) {
  return seen.points[side].empty() && (seen.spots[side] == 0 || seen.faults.empty());
}

/// Of what is not the datum.
Pairs match_target(const Aligned& seen, const LineModel& model) {
  Pairs none;
  if (not_seen(seen, Side::kLeft)) none.faults.insert(Fault::kNotSeenLeft);
  if (not_seen(seen, Side::kRight)) none.faults.insert(Fault::kNotSeenRight);
  const std::size_t left = seen.points.left.size();
  const std::size_t right = seen.points.right.size();
  if (left == 0 || right == 0 || !model.calibrated || !model.calibration_fits) return none;
  if (!model.target.tags.empty()) return match_tags(seen, model);
  if (left > kMaxMatchedSpots || right > kMaxMatchedSpots) return {{}, {Fault::kAmbiguous}};
  const Candidates found = candidates(seen, model);
  const std::size_t points = model.target.points.size();
  if (points == 1) return alone(by_blinking(unique_pairs(found, seen)), model.target);
  if (points < 3) return unidentified(by_blinking(unique_pairs(found, seen)));
  return identified(found, seen, model);
}

}  // namespace

Pairs match(const Aligned& seen, const LineModel& model) {
  if (!seen.common_time) return {};
  if (!model.datum || !model.calibrated || !model.calibration_fits) return match_target(seen, model);
  const Sifted sifted = without_datum(seen, model);
  Pairs found = match_target(sifted.others, model);
  found.datum = sifted.datum;
  if (sifted.ambiguous) found.faults.insert(Fault::kAmbiguous);
  return found;
}

}  // namespace tripoint
