// A Gaussian spot of light, integrated over each pixel in closed form.
#pragma once

#include <span>
#include <vector>

#include "sim/normal_integral.h"
#include "sim/scene.h"
#include "sim/silhouette.h"
#include "values/linear.h"
#include "values/pixel.h"

namespace tripoint {

/// One instant of a spot.
struct GaussianSpot {
  RawPixel at;
  double sigma_px = 1.0;              ///< geometric mean of the two axes
  double elongation = 1.0;            ///< long over short axis
  double elongation_angle_rad = 0.0;  ///< of the long axis, from u towards v
  LinearColor energy{};               ///< sum over all pixels if each were of that colour, clip x px
  double row_px = 0.0;                ///< the row for whose time `at` holds
  Vec2 shift_px_per_row{0.0, 0.0};    ///< how far the spot moves from the time of a row to that of the next
};

/// Mean light level of each pixel under the mosaic: a fixed background, and what comes and goes before it.
class LightPlane {
 public:
  /// @param background  mean levels in units of clip, row by row
  LightPlane(ImageSize size, std::span<const float> background);

  /// Adds what of a spot the masks let pass, out to five standard deviations.
  void add(const GaussianSpot& spot, const NormalIntegral& normal, std::span<const Mask> masks = {});

  /// A row to draw in what hides the background; to be done before spots are added.
  std::span<float> painted_row(int y);

  /// Takes everything out again but the background.
  void clear();

  [[nodiscard]] std::span<const float> row(int y) const;

 private:
  struct Axes;
  void add_to_row(int y, const GaussianSpot& spot, const Axes& axes, const NormalIntegral& normal,
                  std::span<const Mask> masks);

  ImageSize size_;
  std::span<const float> background_;
  std::vector<float> levels_;
  int first_touched_;
  int last_touched_{-1};
};

}  // namespace tripoint
