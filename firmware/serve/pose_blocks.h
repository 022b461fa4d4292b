// A reading in the three number formats of the map.
#pragma once

#include <cstddef>

#include "serve/reading.h"
#include "serve/register_image.h"

namespace tripoint {

/// Registers 100 to 147; `shift` moves them to a block that is like this one.
void put_integer_pose(RegisterImage& image, const Reading& reading, std::size_t shift = 0);
/// Registers 200 to 247.
void put_float_pose(RegisterImage& image, const Reading& reading, std::size_t shift = 0);
/// Registers 300 to 315. What does not fit its range is not valid.
void put_single_pose(RegisterImage& image, const Reading& reading, std::size_t shift = 0);

}  // namespace tripoint
