// The corners of a decoded tag as the places where its edges meet.
#pragma once

#include <array>

#include "tags/edge_meetings.h"
#include "tags/luma_view.h"
#include "tags/tag_cause.h"
#include "tags/tag_decoder.h"
#include "tags/tag_pattern.h"
#include "values/linear.h"

namespace tripoint {

using TagCornerPixels = std::array<RawPixel, kTagCorners>;
std::array<Vec2, kTagCorners> places_of(const TagCornerPixels& corners_px);

/// Measured when the cause is kKept. Otherwise rough: the corners are the decoder's, to about a pixel.
struct TagOutline {
  TagCause cause = TagCause::kKept;
  TagCornerPixels corners_px;  ///< in the order of the decoder
  /// Over u and v of corner 0, of corner 1 and so on. Neighbours share an edge, and so its error.
  CornerCovariance covariance_px2 = CornerCovariance::Identity();
  double light = 0.0;     ///< mean luma on the light side of the edges; 0 of a rough one
  double dark = 0.0;      ///< on the dark side; likewise
  double lightest = 0.0;  ///< mean luma on the light side of the edge where it is highest; likewise
};

/// The library's own corners err by up to a pixel, and in each of its versions in another way: they are only where
/// looking begins. Edges are taken for straight; what a lens moves the corners by is taken off where it is known
/// (straight_corners.h).
///
/// @return rough with the cause of the first edge that cannot be measured, with kMovedCorner or kShiftedCells
TagOutline tag_outline(const LumaView& luma, const DecodedTag& tag, const TagPattern& pattern);

/// Of a tag whose corners were foreseen to about three pixels, or nine tenths of a cell if that is less: asked for all
/// that a decoded one is but kMovedCorner. Its bits are not read here.
///
/// @return without a place when the cause is not kKept
TagOutline outline_near(const LumaView& luma, const TagCornerPixels& foreseen, const TagPattern& pattern);

struct MeasuredPlace {
  RawPixel at;
  Matrix2 covariance_px2 = Matrix2::Zero();
};

/// Where the decoder says, with the deviation of a pixel.
TagOutline rough_outline(const DecodedTag& tag, TagCause cause);

/// One corner.
MeasuredPlace corner_of(const TagOutline& outline, std::size_t corner);
/// The picture of the tag's centre: the diagonals meet there, however the tag is turned.
MeasuredPlace centre_of(const TagOutline& outline);

}  // namespace tripoint
