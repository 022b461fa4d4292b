#include "tags/tag_near.h"

#include <cmath>
#include <cstddef>

#include "tags/tag_plane.h"

namespace tripoint {
namespace {

struct ReadBits {
  int wrong = 0;
  double margin = 0.0;
};

/// @return nothing when a bit lies outside of the picture
std::optional<ReadBits> bits_in(const LumaView& luma, const TagOutline& outline, const TagPattern& pattern) {
  const TagPlane plane(places_of(outline.corners_px));
  const double threshold = 0.5 * (outline.light + outline.dark);
  ReadBits read;
  for (const CellMiddle& bit : pattern.bits) {
    const std::optional<float> value = luma.at(plane.at(bit.at).at_px);
    if (!value) return std::nullopt;
    const double above = static_cast<double>(*value) - threshold;
    if ((above > 0.0) != bit.light) ++read.wrong;
    read.margin += std::abs(above) / static_cast<double>(pattern.bits.size());
  }
  return read;
}

}  // namespace

std::optional<SeenTag> tag_near(const LumaView& luma, const TagCornerPixels& foreseen, const KnownTag& known) {
  const TagOutline outline = outline_near(luma, foreseen, known.pattern);
  if (outline.cause != TagCause::kKept) return std::nullopt;
  const std::optional<ReadBits> read = bits_in(luma, outline, known.pattern);
  if (!read || read->wrong > known.most_wrong_bits || !(read->margin >= known.min_margin)) return std::nullopt;
  return SeenTag{{known.id, read->wrong, read->margin, outline.corners_px}, outline};
}

}  // namespace tripoint
