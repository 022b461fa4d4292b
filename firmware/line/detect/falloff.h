// The cheap first question: is it bright, and does it fall off on nearly all sides?
#pragma once

#include "line/detect/candidate.h"
#include "ports/frame.h"

namespace tripoint {

/// Largest 3 Y + 4 V (V not interpolated) within 2 px.
int brightest_near(const Picture& picture, PixelPlace start);

/// Whether at 4, 8, 16 or 30 px at least 6 of 8 directions are below `level`; outside the picture is below.
bool falls_below(const Picture& picture, PixelPlace start, int level);

}  // namespace tripoint
