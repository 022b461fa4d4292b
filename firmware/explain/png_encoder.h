// An image as the bytes of a PNG file.
#pragma once

#include <string>

#include "explain/rgb_image.h"
#include "values/result.h"

namespace tripoint {

/// @param image  not empty
/// @return 24-bit RGB without transparency; kCannotWrite with libpng's words when it refuses (memory)
/// Source: PNG specification, third edition (W3C 2025); written by libpng.
Result<std::string> png_of(const RgbImage& image);

}  // namespace tripoint
