// An explained picture as one image: heading, the whole picture, close-ups.
#pragma once

#include <span>

#include "explain/heading.h"
#include "explain/rgb_image.h"

namespace tripoint {

inline constexpr ImageSize kCloseUpSize{200, 264};

/// @param close_ups  of kCloseUpSize; they fill rows below the picture
RgbImage sheet_of(const Heading& heading, const RgbImage& picture, std::span<const RgbImage> close_ups);

}  // namespace tripoint
