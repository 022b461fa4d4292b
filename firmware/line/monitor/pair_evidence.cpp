#include "line/monitor/pair_evidence.h"

namespace tripoint {

std::optional<PairEvidence> pair_evidence(const Pair& pair, const LineModel& model) {
  const PerSide<MeasuredPixel> pixels{{pair.points.left.seen.at, pair.points.left.seen.covariance_px2},
                                      {pair.points.right.seen.at, pair.points.right.seen.covariance_px2}};
  const Result<TriangulatedPoint> place = triangulated(model.rig, pixels, model.limits.min_angle_rad);
  const std::optional<EpipolarGate> epipolar = epipolar_gate(model, pixels);
  const auto gradient = epipolar_calibration_gradient(model.calibration, {pixels.left.at, pixels.right.at});
  if (!place || !epipolar || !gradient) return std::nullopt;
  return PairEvidence{pixels, *place, *epipolar, calibration_jacobian(model.calibration, pixels), *gradient};
}

}  // namespace tripoint
