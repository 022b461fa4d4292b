// What a tag of a family looks like on paper.
#pragma once

#include <string_view>

#include "values/result.h"
#include "values/tag_cells.h"

namespace tripoint {

/// @return as TagDecoder::open; kOutOfRange when the family has no such id
Result<TagCells> tag_print(std::string_view family, int id);

}  // namespace tripoint
