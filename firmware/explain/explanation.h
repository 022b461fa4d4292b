// One image that shows a picture, everything the detector looked at in it, and why it was kept or dropped.
#pragma once

#include <string_view>

#include "explain/rgb_image.h"
#include "line/detect/detector_settings.h"
#include "line/detect/led_detector.h"
#include "ports/frame.h"

namespace tripoint {

/// What the detector saw and said.
struct Explained {
  const Picture& picture;
  const CandidateLog& log;
  const Detection& detection;
  const DetectorSettings& settings;
};

/// The picture with its marks; above it what was found, below it close-ups of the kept and of the most telling
/// dropped candidates. Marks without room for a label, and candidates without a close-up, are counted in words.
///
/// @param title  the picture's name; letters beyond ASCII are shown as '?'
RgbImage explanation_of(const Explained& explained, std::string_view title);

}  // namespace tripoint
