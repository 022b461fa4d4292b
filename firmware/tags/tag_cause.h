// Why the outline of a decoded tag is measured or not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tripoint {

enum class TagCause : std::uint8_t {
  kKept,
  kUnsureBits,    ///< the bits are hardly lighter or darker than what parts them: margin below `min_margin`
  kTooSmall,      ///< an edge is too short to be measured
  kCutByBorder,   ///< the picture ends too near to an edge
  kNoContrast,    ///< no step from dark to light across an edge
  kCrookedEdge,   ///< an edge is no straight line: bent or partly hidden
  kBlurred,       ///< an edge is so wide that not all of it was looked at: motion, or out of focus
  kUnevenLight,   ///< beside an edge light changes as it does not on paper: a cover, or bits too small to be told apart
  kMovedCorner,   ///< the edges meet elsewhere than where the tag was decoded
  kShiftedCells,  ///< the cells inside do not lie where the corners put them: what looks like an edge is a cover's
};
inline constexpr std::array<std::string_view, 10> kTagCauseNames{
    "kept",         "unsure_bits", "too_small",    "cut_by_border", "no_contrast",
    "crooked_edge", "blurred",     "uneven_light", "moved_corner",  "shifted_cells"};

constexpr std::string_view name(TagCause cause) { return kTagCauseNames[static_cast<std::size_t>(cause)]; }

}  // namespace tripoint
