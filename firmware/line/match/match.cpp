#include "line/match/match.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/triangulation.h"
#include "line/match/epipolar.h"

namespace tripoint {
namespace {

// Room for two cameras that are focused and exposed a little differently and see a LED from two sides.
constexpr double kMostSizeRatio = 2.0;
constexpr double kMostBrightnessRatio = 4.0;

struct DepthRange {
  double min_mm = 0.0;
  double max_mm = std::numeric_limits<double>::infinity();
};

/// Depths in the reference frame that the working volume's corners span.
DepthRange depth_range(const LineModel& model) {
  if (!model.volume) return {};
  const Isometry3 rig_from_output = model.output_from_rig.inverse();
  DepthRange range{std::numeric_limits<double>::infinity(), 0.0};
  for (int corner = 0; corner < 8; ++corner) {
    const auto pick = [&](int axis) {
      return (corner >> axis) % 2 == 0 ? model.volume->min_mm[axis] : model.volume->max_mm[axis];
    };
    const double depth_mm = (rig_from_output * Vec3{pick(0), pick(1), pick(2)}).z();
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

bool within_ratio(double a, double b, double most) { return a <= most * b && b <= most * a; }

/// One light is about as large and as bright in both pictures. Corners of tags have neither size nor brightness; far
/// above clip a spot's size is that of its glare, and a weak spot's brightness is on another scale.
bool alike(const ImagePoint& left, const ImagePoint& right) {
  if (left.saturated || right.saturated) return true;
  const bool sizes = within_ratio(left.sigma_px, right.sigma_px, kMostSizeRatio);
  return sizes && (left.weak != right.weak || within_ratio(left.amplitude, right.amplitude, kMostBrightnessRatio));
}

/// Two that blink as different LEDs are no pair, wherever they are.
bool same_led(const ImagePoint& left, const ImagePoint& right) {
  return left.led == 0 || right.led == 0 || left.led == right.led;
}

/// What speaks against a pair inside the epipolar gate, nothing when it is possible.
Faults against(const PerSide<MeasuredPixel>& pixels, const DepthRange& range, const LineModel& model) {
  const Result<TriangulatedPoint> point = triangulated(model.rig, pixels, model.limits.min_angle_rad);
  if (!point) return {Fault::kGeometryGate};
  const double depth_mm = point->in_rig_mm.z();
  if (depth_mm < range.min_mm || depth_mm > range.max_mm) return {Fault::kOutsideVolume};
  return {};
}

struct Candidate {
  PerSide<std::size_t> index{0, 0};
  EpipolarGate gate;
};

struct Candidates {
  FixedVector<Candidate, kMaxMatchedSpots * kMaxMatchedSpots> pairs;
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
      const Faults reasons = against(pixels, range, model);
      found.refused.insert(reasons);
      if (!reasons.empty()) continue;
      // Two that are not alike are believed by nobody, but they may be the true pair: neither has another partner then.
      if (alike(seen.points.left[i].seen, seen.points.right[j].seen)) {
        found.pairs.push_back({{i, j}, *gate});
      } else {
        found.refused.insert(Fault::kGeometryGate);
      }
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

Pairs unique_pairs(const Candidates& found, const Aligned& seen) {
  Pairs unique;
  for (const Candidate& candidate : found.pairs) {
    const PerSide<std::size_t>& at = candidate.index;
    if (found.partners.left[at.left] == 1 && found.partners.right[at.right] == 1) {
      unique.pairs.push_back({0,
                              {seen.points.left[at.left], seen.points.right[at.right]},
                              candidate.gate.distance_px,
                              candidate.gate.sigma_px});
    } else {
      unique.faults.insert(Fault::kAmbiguous);
    }
  }
  if (found.pairs.empty()) unique.faults.insert(why_none(found.refused));
  return unique;
}

/// By their blinking, or a single one by being alone.
Pairs identified(Pairs unique, const Target& target) {
  if (unique.pairs.empty()) return unique;
  for (Pair& pair : unique.pairs) {
    const std::uint16_t led = pair.points.left.seen.led;
    if (led == pair.points.right.seen.led) pair.id = led;
  }
  if (target.points.size() == 1 && unique.pairs.size() == 1 && unique.faults.empty()) {
    unique.pairs[0].id = target.points[0].id;
  } else {
    unique.faults.insert(Fault::kAmbiguous);
  }
  return unique;
}

/// A side without points, unless align already said why it has none.
bool not_seen(const Aligned& seen, Side side) {
  return seen.points[side].empty() && (seen.spots[side] == 0 || seen.faults.empty());
}

}  // namespace

Pairs match(const Aligned& seen, const LineModel& model) {
  Pairs none;
  if (!seen.common_time) return none;
  if (not_seen(seen, Side::kLeft)) none.faults.insert(Fault::kNotSeenLeft);
  if (not_seen(seen, Side::kRight)) none.faults.insert(Fault::kNotSeenRight);
  const std::size_t left = seen.points.left.size();
  const std::size_t right = seen.points.right.size();
  if (left == 0 || right == 0 || !model.calibrated || !model.calibration_fits) return none;
  if (left > kMaxMatchedSpots || right > kMaxMatchedSpots) return {{}, {Fault::kAmbiguous}};
  return identified(unique_pairs(candidates(seen, model), seen), model.target);
}

}  // namespace tripoint
