// What the line and the detectors need to know of a target.
#pragma once

#include <string>

#include "line/model.h"

namespace tripoint {

struct MeasuredTarget {
  Target target;
  std::string tag_family;  ///< of tags
};

}  // namespace tripoint
