#include "bench/tracked_pair.h"

#include <algorithm>
#include <array>

namespace tripoint::bench {
namespace {

constexpr double kAcross_mm2 = 0.06 * 0.06;  // 0.1 px at 390 mm
constexpr double kDeep_mm2 = 0.35 * 0.35;    // and with 100 mm between the cameras

}  // namespace

TrackedPair::TrackedPair(ImageSize size) : size_(size), measurer_(size) {
  model_.rig = measurer_.rig();
  int id = 1;
  for (const Vec3& led : kLedsOfPair_mm) model_.target.points.push_back({.id = id++, .in_target_mm = led});
}

std::size_t TrackedPair::measure(const PairBytes& pair) {
  ++frame_;
  exposed_ += kPairPeriod;
  whole_ = 0;
  const PerSide<Picture> pictures{decoded(pair, Side::kLeft), decoded(pair, Side::kRight)};
  const std::size_t points = measurer_.measure(pictures);
  for (const Side side : kBothSides) remember(pictures[side], side);
  if (points == kLedsOfPair) learn();
  forecast_ = monitor_.forecast(kPairPeriod, model_);
  return points;
}

Picture TrackedPair::decoded(const PairBytes& pair, Side side) {
  const RowBands bands = chosen_bands(sightings_[side], forecast_, {side, frame_, exposed_, size_});
  return decoders_[side].decode(pair[side], size_, bands).value();
}

void TrackedPair::remember(const Picture& picture, Side side) {
  Observation seen;
  seen.side = side;
  seen.frame = frame_;
  seen.exposed = exposed_;
  seen.coverage = picture.bands.empty() ? Coverage::kWholeFrame : Coverage::kRegions;
  seen.points = measurer_.seen()[side].points;
  seen.health = measurer_.seen()[side].health;
  sightings_[side] = with(sightings_[side], seen, forecast_);
  whole_ += picture.bands.empty() ? 1U : 0U;
}

/// The LEDs are told by their order in x: the target does not turn.
void TrackedPair::learn() {
  std::array<Vec3, kLedsOfPair> found;
  std::ranges::copy(measurer_.in_rig_mm(), found.begin());
  std::ranges::sort(found, {}, [](const Vec3& point) { return point.x(); });
  Measurement measurement;
  measurement.common_time = true;
  measurement.exposed = exposed_;
  measurement.pose = TargetPose{};
  measurement.pose->output_from_target = Matrix3::Identity();
  measurement.pose->noise.diagonal().head<3>() = Vec3(kAcross_mm2, kAcross_mm2, kDeep_mm2) / kLedsOfPair;
  for (std::size_t i = 0; i < kLedsOfPair; ++i) {
    measurement.pose->position_in_output_mm += (found[i] - kLedsOfPair_mm[i]) / kLedsOfPair;
  }
  monitor_.learn(measurement, {});
}

}  // namespace tripoint::bench
