// What finds the target's points in a picture: the configured detector as a camera's thread calls it.
#pragma once

#include "app/measured_target.h"
#include "capture/camera_worker.h"
#include "config/config.h"
#include "line/observation.h"
#include "values/result.h"

namespace tripoint {

/// A detector of its own for one camera.
///
/// @param target  of what the configured detector finds
/// @return as TagDetector::open; kOutOfRange for a tag that its family does not have
Result<DetectPoints> detection_of(const DetectorConfig& config, const MeasuredTarget& target);

/// Whether the detector must be given every picture whole: a tag is read from all of its rows.
bool needs_whole_pictures(const DetectorConfig& config);

}  // namespace tripoint
