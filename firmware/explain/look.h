// Colours and letters of an explanation, the same in each of its parts.
#pragma once

#include "explain/canvas.h"
#include "explain/finding.h"
#include "explain/rgb_image.h"

namespace tripoint {

inline constexpr Colour kGround{20, 23, 28};
inline constexpr Colour kPlate{10, 12, 15};
inline constexpr Colour kOutside{44, 49, 58};  ///< where a close-up reaches beyond the picture
inline constexpr Colour kText{232, 236, 241};
inline constexpr Colour kFaint{154, 164, 178};
inline constexpr Colour kKeptColour{52, 232, 150};
inline constexpr Colour kDroppedColour{255, 196, 46};
inline constexpr Colour kAreaColour{120, 190, 255};

inline constexpr int kMargin_px = 20;
inline constexpr double kSmall_px = 9.0;  ///< heights of capitals
inline constexpr double kMedium_px = 11.0;
inline constexpr double kLarge_px = 16.0;

/// How an uncertainty is drawn everywhere, overview and close-ups: px of the drawing for one of the picture.
inline constexpr double kUncertaintyScale = 25.0;
inline constexpr double kPlateOpacity = 0.72;  ///< below letters on a picture
inline constexpr double kHalo_px = 1.25;

/// A cross, the ellipse of `shape` and their colour: a spot that was kept.
void draw_kept(Canvas& canvas, CanvasPoint at, const EllipseShape& shape);
/// A square of this half side: a place that was dropped.
void draw_dropped(Canvas& canvas, CanvasPoint at, double reach_px);

/// Half axes of the three standard deviations of a centre, `scale` px for each px of the picture.
EllipseShape three_sigma(const Matrix2& covariance_px2, double scale);

Colour colour_of(const Finding& finding);

}  // namespace tripoint
