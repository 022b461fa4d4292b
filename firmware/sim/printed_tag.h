// An AprilTag on the target: flat paper, printed on one side.
#pragma once

#include "values/linear.h"
#include "values/tag_cells.h"

namespace tripoint {

/// In its own frame the middle is the origin, x runs right, y down and z into the tag, as in libapriltag. The paper
/// ends with the outermost cells.
struct PrintedTag {
  int id = 0;
  TagCells cells;
  double size_mm = 30.0;  ///< of the square with the four corners
  Isometry3 target_from_tag = Isometry3::Identity();
  double light_reflectance = 0.8;  ///< of white paper
  double dark_reflectance = 0.04;  ///< of printed black
  double back_reflectance = 0.3;   ///< of the plain other side
};

}  // namespace tripoint
