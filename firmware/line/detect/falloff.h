// The cheap first question: is it bright, and does it fall off on nearly all sides?
#pragma once

#include <optional>

#include "line/detect/candidate.h"
#include "ports/frame.h"

namespace tripoint {

/// Largest 3 Y + 4 V (V not interpolated) within 2 px.
int brightest_near(const Picture& picture, PixelPlace start);

/// The first of 4, 8, 16 and 30 px at which at least 6 of 8 directions are below `level`; outside the picture is below.
///
/// @return nothing when it falls off at none of them
std::optional<int> falloff_px(const Picture& picture, PixelPlace start, int level);

}  // namespace tripoint
