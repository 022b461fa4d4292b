// A few pixels of the picture, large, around one candidate, and what was measured there.
#pragma once

#include "explain/finding.h"
#include "explain/sheet.h"
#include "line/detect/detector_settings.h"

namespace tripoint {

/// Eight times as large as the picture; four times, twice or as it is for spots that would not fit and for surfaces.
///
/// @param picture  in its own size; the levels are shown as they are
RgbImage close_up_of(const RgbImage& picture, const Finding& finding, const DetectorSettings& settings);

}  // namespace tripoint
