// `tripointd detect` with the detector apriltag: which tags picture files show, and where.
#pragma once

#include "app/detect_command.h"
#include "config/config.h"

namespace tripoint {

/// Prints one JSON line for each image: the tags, with corners that are measured or why they are rough, those that are
/// dropped, or why the image cannot be read. With `explain` also where its image was written.
///
/// @return 0, or 2 when there is no such family of tags, any image could not be decoded or any explanation not be
///         written
int detect_tags(const DetectOptions& options, const DetectorConfig& config);

}  // namespace tripoint
