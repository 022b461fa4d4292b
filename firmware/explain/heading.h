// What stands above an explained picture: its name, what was found in it, and what the marks mean.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "explain/canvas.h"
#include "explain/rgb_image.h"

namespace tripoint {

/// A mark, drawn around a point, and what it says.
struct Meaning {
  std::function<void(Canvas&, CanvasPoint)> draw;
  std::string text;
};

struct Heading {
  std::string title;
  std::string size;  ///< of the picture, in words
  int kept = 0;
  int dropped = 0;
  std::string causes;              ///< why they were dropped
  std::vector<std::string> notes;  ///< what a reader must know, one line each
  std::vector<Meaning> legend;
};

RgbImage heading_of(const Heading& heading, int width_px);

}  // namespace tripoint
