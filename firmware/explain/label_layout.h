// Where labels go beside their marks, so that none hides another or a mark.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "explain/canvas.h"

namespace tripoint {

struct Mark {
  CanvasPoint at;
  double reach_px = 0.0;  ///< half the side of the square that it takes
};

struct Label {
  Mark mark;
  double width_px = 0.0;
  double height_px = 0.0;
};

/// The first labels get their place first.
///
/// @param room   no label leaves it
/// @param marks  all of them, also those without a label: no label lies on one
/// @return for each label its box, or nothing where every place beside its mark is taken
std::vector<std::optional<Box>> places_of(std::span<const Label> labels, const Box& room, std::span<const Mark> marks);

}  // namespace tripoint
