// Whether a spot of the left picture and one of the right can be one light, by their looks alone.
#pragma once

#include "line/observation.h"

namespace tripoint {

/// One light is about as large and as bright in both pictures. Corners of tags have neither size nor brightness; far
/// above clip a spot's size is that of its glare, and a weak spot's brightness is on another scale.
bool alike(const ImagePoint& left, const ImagePoint& right);

}  // namespace tripoint
