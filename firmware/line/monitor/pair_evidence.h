// What one pair of image points says of where the cameras stand.
#pragma once

#include <optional>

#include "geometry/triangulation.h"
#include "line/match/epipolar.h"
#include "line/match/match.h"
#include "line/model.h"

namespace tripoint {

/// A place and an epipolar distance, uncorrelated to first order, each with its noise of the image points alone.
struct PairEvidence {
  PerSide<MeasuredPixel> pixels;
  TriangulatedPoint place;
  EpipolarGate epipolar;
  Eigen::Matrix<double, 3, 24> place_by_calibration;
  RigParameters epipolar_by_calibration;
};

/// @return nothing when the rays do not meet in front of both cameras
std::optional<PairEvidence> pair_evidence(const Pair& pair, const LineModel& model);

}  // namespace tripoint
