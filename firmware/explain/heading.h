// What stands above an explained picture: its name, what was found in it, and what the marks mean.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "explain/finding.h"
#include "explain/rgb_image.h"

namespace tripoint {

struct Heading {
  std::string title;
  std::string size;                ///< of the picture, in words
  std::vector<std::string> notes;  ///< what a reader must know, one line each
};

RgbImage heading_of(const Heading& heading, std::span<const Finding> findings, int width_px);

/// "3 not red, 1 dim": causes with their number, the most frequent first; empty when nothing was dropped.
std::string tally_of_dropped(std::span<const Finding> findings);

}  // namespace tripoint
