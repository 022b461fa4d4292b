// PNG data to the packed formats that cameras deliver, so that everything behind sees one kind of picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ports/frame.h"
#include "values/result.h"

namespace tripoint {

/// A picture packed as YUYV, or as GREY when the file has no colour.
struct PackedPicture {
  ImageSize size;
  PixelFormat format = PixelFormat::kGrey;
  std::size_t stride_bytes = 0;  ///< for an odd width the last YUYV pair repeats the last pixel
  std::vector<std::uint8_t> data;
};

/// Decodes any PNG up to kMaxPictureSide_px; transparency is shown before black.
///
/// @return full-range levels as in JFIF, chroma averaged over each pair of pixels;
///         kCorruptFrame for data that is damaged, ends early or is too large
/// Source of the conversion: ITU-R BT.601, full range as in JFIF 1.02.
Result<PackedPicture> picture_from_png(std::span<const std::uint8_t> png);

}  // namespace tripoint
