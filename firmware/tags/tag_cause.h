// Why the outline of a decoded tag is measured or not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tripoint {

enum class TagCause : std::uint8_t {
  kKept,
  kUnsureBits,   ///< the bits are hardly lighter or darker than what parts them: margin below `min_margin`
  kTooSmall,     ///< an edge is too short to be measured
  kCutByBorder,  ///< the picture ends too near to an edge
  kNoContrast,   ///< no step from dark to light across an edge
  kCrookedEdge,  ///< an edge is no straight line: bent or partly hidden
  kBlurred,      ///< an edge is so wide that not all of it was looked at: motion, or out of focus
  kMovedCorner,  ///< the edges meet elsewhere than where the tag was decoded
};
inline constexpr std::array<std::string_view, 8> kTagCauseNames{
    "kept", "unsure_bits", "too_small", "cut_by_border", "no_contrast", "crooked_edge", "blurred", "moved_corner"};

constexpr std::string_view name(TagCause cause) { return kTagCauseNames[static_cast<std::size_t>(cause)]; }

}  // namespace tripoint
