// A picture as large as people want it, and labels beside the marks on it.
#pragma once

#include <span>
#include <string>

#include "explain/canvas.h"
#include "explain/label_layout.h"
#include "explain/rgb_image.h"
#include "values/pixel.h"

namespace tripoint {

/// How large a picture is shown: enlarged by whole pixels, or reduced by whole divisors.
struct Magnification {
  int enlarged = 1;
  int reduced = 1;

  [[nodiscard]] double scale() const { return static_cast<double>(enlarged) / reduced; }
};

/// Small pictures are shown up to 1280 px, larger ones at most 1920 px wide and high.
Magnification magnification_of(ImageSize size);

/// "640 x 480 px, shown x 2"
std::string size_in_words(ImageSize size, const Magnification& magnification);

struct ShownPicture {
  RgbImage image;
  Magnification magnification;
  bool brightened = false;  ///< a dark picture is shown brighter than it is
};

ShownPicture shown(const RgbImage& picture);

/// Where a place of the picture lies in the shown one; the outer edges of both are the same.
CanvasPoint shown_at(RawPixel place, double scale);

struct MarkLabel {
  Mark mark;
  std::string text;
  Type type;
};

/// The first ones get their room first; a line leads from a mark to a label that lies far from it.
///
/// @return how many found no room
int write_labels(Canvas& canvas, std::span<const MarkLabel> all);

}  // namespace tripoint
