// One pair of image points as a point in space, with what moves it.
#pragma once

#include "line/align/align.h"
#include "line/match/match.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/pose/body_pose.h"
#include "values/fixed_vector.h"
#include "values/result.h"

namespace tripoint {

/// By the model's method.
///
/// @param of  the point of the target that it is; of an unidentified one only its place counts
/// @return as triangulated
Result<LocatedPoint> located(const Pair& pair, const TargetPoint& of, const Aligned& seen, const LineModel& model);

/// The points of the target that were told: LEDs by their names, of each tag the corners, one tag after the other.
///
/// @return as triangulated
Result<FixedVector<LocatedPoint, kMaxImagePoints>> located_target(const Pairs& pairs, const Aligned& seen,
                                                                  const LineModel& model);

/// Of a tag that the target has.
std::size_t place_of_tag(int id, const Target& target);

/// The calibration's part of the place's covariance, in the output frame.
Matrix3 shared_in_output_mm2(const LocatedPoint& at, const LineModel& model);

/// Mean over both pictures.
double residual_square_px2(const LocatedPoint& at);

/// As it is published, in the output frame.
MeasuredPoint measured_point(const Pair& pair, const LocatedPoint& at, const LineModel& model);

}  // namespace tripoint
