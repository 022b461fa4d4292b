// LEDs at random places of rendered pictures, as the detector measures them, against where the renderer put them.
#pragma once

#include <cstdint>
#include <vector>

#include "line/detect/settings.h"
#include "sim/settings.h"
#include "values/linear.h"

namespace tripoint::bench {

/// Pictures of 24 LEDs far from each other, at 400 mm before the grey wall, seen by the left camera of the default rig.
struct SpotPictures {
  ImageSize size{.width_px = 640, .height_px = 480};
  PixelFormat format = PixelFormat::kYuyv;
  ChromaSampling sampling = ChromaSampling::k422;  ///< of MJPEG
  int quality = 90;                                ///< of MJPEG
  double peak = 1.0;                               ///< of each LED's core, times clip: red just reaches it
  SensorModel sensor{};
};

/// The scene and cameras of such pictures, with one LED in the middle.
SimulationSettings one_spot(const SpotPictures& pictures);

struct SpotError {
  Vec2 error_px;
  Matrix2 stated_px2;

  [[nodiscard]] double chi2() const;  ///< of two axes, 2 in the mean for true normal errors
};

struct SpotErrors {
  int asked = 0;
  std::vector<SpotError> found{};

  [[nodiscard]] double rms_px() const;           ///< per axis
  [[nodiscard]] double rms_over_stated() const;  ///< per axis; 1 where the covariances are right
  [[nodiscard]] double share_in_95() const;      ///< of the found, whose ellipse of 95 % holds the truth
};

/// Of `count` pictures, in each of which all LEDs fall on other parts of a pixel. The same seed gives the same spots.
SpotErrors spot_errors(const SpotPictures& pictures, int count, std::uint64_t seed,
                       const LedDetectorSettings& detector = {});

}  // namespace tripoint::bench
