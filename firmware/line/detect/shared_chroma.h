// What chroma that pixels share leaves of a small spot's red. The limits of red are those of 4:2:2, as in YUYV.
#pragma once

#include <cmath>
#include <numbers>

#include "ports/frame.h"

namespace tripoint {

inline constexpr double kSharpestSigma_px = 1.0;  ///< behind a lens and a mosaic

/// Share of the V that a Gaussian spot has in 4:2:2: where two rows share it, half goes to each of the pairs between
/// which the spot lies. The mean over two rows beside its middle is erf(2 / (sqrt 2 sigma)) / 4, that over the row in
/// its middle erf(0.5 / (sqrt 2 sigma)).
inline double red_left(const Picture& picture, double sigma_px = kSharpestSigma_px) {
  if (!picture.chroma_rows_halved) return 1.0;
  const double scale = 1.0 / (std::numbers::sqrt2 * sigma_px);
  return std::erf(2.0 * scale) / (4.0 * std::erf(0.5 * scale));
}

/// The same of its strength above that of darkness. Of that of pure red, 3 Y is 0.897 and 4 V 2 (ITU-R BT.601-7,
/// section 2.5): luma is not shared.
inline double strength_left(const Picture& picture, double sigma_px = kSharpestSigma_px) {
  constexpr double kLuma = 0.897 / 2.897;
  return kLuma + (1.0 - kLuma) * red_left(picture, sigma_px);
}

}  // namespace tripoint
