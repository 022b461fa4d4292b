// Pictures whose every value is known, and their encoding by libjpeg and libpng.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "values/pixel.h"

namespace tripoint::test {

using Level = std::function<int(int x, int y)>;

/// Components at full resolution; libjpeg reduces the chroma itself.
struct SmoothPicture {
  ImageSize size;
  Level luma;
  Level u;
  Level v;
};

/// Slopes of at most one level a pixel, so that chroma averaging changes little.
SmoothPicture smooth_picture(ImageSize size);

struct JpegKind {
  int luma_h = 2;  ///< sampling factors of luma; chroma has 1 and 1
  int luma_v = 1;
  bool grey = false;
  bool progressive = false;
  bool many_scans = false;      ///< progressive, with a scan for each of 40 coefficients: legal, and slow to decode
  bool without_tables = false;  ///< leaves the Huffman tables out, as webcams do
  int quality = 100;
};

std::vector<std::uint8_t> jpeg_of(const SmoothPicture& picture, const JpegKind& kind);
std::vector<std::uint8_t> png_of(ImageSize size, bool colour, const std::vector<std::uint8_t>& values);

/// The folder of real data, or a path that does not exist.
std::filesystem::path shared_data();

}  // namespace tripoint::test
