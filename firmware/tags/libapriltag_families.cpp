#include "tags/libapriltag_families.h"

#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>

#include <algorithm>
#include <array>
#include <string>

namespace tripoint {
namespace {

constexpr std::array<NamedFamily, 9> kFamilies{{
    {"tag36h11", tag36h11_create, tag36h11_destroy},
    {"tag16h5", tag16h5_create, tag16h5_destroy},
    {"tag25h9", tag25h9_create, tag25h9_destroy},
    {"tag36h10", tag36h10_create, tag36h10_destroy},
    {"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
    {"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
    {"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
    {"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    {"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy},
}};

std::string names_of_families() {
  std::string names;
  for (const NamedFamily& family : kFamilies) names += (names.empty() ? "" : " ") + std::string(family.name);
  return names;
}

}  // namespace

Result<NamedFamily> family_named(std::string_view name) {
  const auto* const named =
      std::find_if(kFamilies.begin(), kFamilies.end(), [&](const NamedFamily& known) { return known.name == name; });
  if (named != kFamilies.end()) return *named;
  return failure(ErrorCode::kOutOfRange,
                 "\"" + std::string(name) + "\" is no family of AprilTags: permitted is one of " + names_of_families());
}

}  // namespace tripoint
