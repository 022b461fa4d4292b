// The whole picture with a mark on everything the detector looked at.
#pragma once

#include <span>

#include "explain/finding.h"
#include "explain/marked_picture.h"
#include "line/detect/detector_settings.h"

namespace tripoint {

struct Overview {
  ShownPicture picture;  ///< with the marks
  int unlabelled = 0;    ///< marks whose label found no room
};

/// @param picture  in its own size
/// @param findings  as findings_of orders them: the first get their labels first
Overview overview_of(const RgbImage& picture, std::span<const Finding> findings, const DetectorSettings& settings);

}  // namespace tripoint
