// The whole picture with a mark on everything the detector looked at.
#pragma once

#include <span>

#include "explain/finding.h"
#include "explain/rgb_image.h"
#include "line/detect/detector_settings.h"

namespace tripoint {

/// How large a picture is shown: enlarged by whole pixels, or reduced by whole divisors.
struct Magnification {
  int enlarged = 1;
  int reduced = 1;

  [[nodiscard]] double scale() const { return static_cast<double>(enlarged) / reduced; }
};

/// Small pictures are shown up to 1280 px, larger ones at most 1920 px wide and high.
Magnification magnification_of(ImageSize size);

struct Overview {
  RgbImage image;
  Magnification magnification;
  int unlabelled = 0;       ///< marks whose label found no room
  bool brightened = false;  ///< a dark picture is shown brighter than it is
};

/// @param picture  in its own size
/// @param findings  as findings_of orders them: the first get their labels first
Overview overview_of(const RgbImage& picture, std::span<const Finding> findings, const DetectorSettings& settings);

}  // namespace tripoint
