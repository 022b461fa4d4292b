// The families of tags that libapriltag has.
#pragma once

#include <apriltag/apriltag.h>

#include <string_view>

#include "values/result.h"

namespace tripoint {

struct NamedFamily {
  std::string_view name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

/// @return kOutOfRange for no name of a family, naming those that are
Result<NamedFamily> family_named(std::string_view name);

}  // namespace tripoint
