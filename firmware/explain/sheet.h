// An explained picture as one image: heading, the whole picture, close-ups.
#pragma once

#include <array>
#include <span>
#include <string>

#include "explain/heading.h"
#include "explain/rgb_image.h"

namespace tripoint {

inline constexpr ImageSize kCloseUpSize{200, 264};

/// A close-up of kCloseUpSize.
///
/// @param pixels  as wide and high as kCloseUpSize is wide
/// @param lines   below them: what it is, in its colour; why; where, or of what kind
RgbImage close_up_with(const RgbImage& pixels, Colour colour, const std::array<std::string, 3>& lines);

/// @param close_ups  of kCloseUpSize; they fill rows below the picture
RgbImage sheet_of(const Heading& heading, const RgbImage& picture, std::span<const RgbImage> close_ups);

}  // namespace tripoint
