// One tag looked for where it is foreseen, without decoding the picture.
#pragma once

#include <optional>

#include "tags/luma_view.h"
#include "tags/tag_corners.h"
#include "tags/tag_decoder.h"
#include "tags/tag_pattern.h"

namespace tripoint {

struct SeenTag {
  DecodedTag decoded;
  TagOutline outline;
};

/// What a tag must show to be the one that was decoded before.
struct KnownTag {
  const TagPattern& pattern;
  int id = 0;
  int most_wrong_bits = 0;  ///< those that the decoder had to correct
  double min_margin = 0.0;  ///< mean distance of the bits from the threshold, luma steps
};

/// Measured as outline_near does, then read: every bit must be that of its id.
///
/// @return nothing when it is not there, is covered, or cannot be measured: the picture has to be decoded
std::optional<SeenTag> tag_near(const LumaView& luma, const TagCornerPixels& foreseen, const KnownTag& known);

}  // namespace tripoint
