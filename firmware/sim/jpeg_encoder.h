// MJPEG as webcams send it: one baseline JPEG a frame.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/developing.h"

namespace tripoint {

enum class ChromaSampling : std::uint8_t { k422, k420 };

/// @param planes   full range; width and height multiples of 16
/// @param quality  1 to 100, libjpeg's scale
std::vector<std::uint8_t> jpeg_from(const YuvPlanes& planes, ChromaSampling sampling, int quality);

}  // namespace tripoint
