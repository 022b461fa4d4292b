// One image that shows a picture, every tag that was decoded in it, and why its corners are measured or not.
#pragma once

#include <string>
#include <string_view>

#include "explain/rgb_image.h"
#include "ports/frame.h"
#include "tags/tag_detector.h"

namespace tripoint {

/// What was measured of a tag, or what speaks against its corners, in words and numbers.
std::string why(const SeenTag& tag, double min_margin);

/// The picture with the outline of each tag; above it how many were measured, below it close-ups.
///
/// @param min_margin  of the detector's settings
/// @param title       the picture's name; letters beyond ASCII are shown as '?'
RgbImage explanation_of(const Picture& picture, const SeenTags& seen, double min_margin, std::string_view title);

}  // namespace tripoint
