// JPEG data to planes, without colour conversion and without believing a damaged picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ports/frame.h"
#include "values/result.h"

namespace tripoint {

inline constexpr int kMaxPictureSide_px = 4096;

/// Keeps its planes from picture to picture: after the first one only libjpeg itself allocates.
class MjpegDecoder {
 public:
  /// Decodes one JPEG, baseline or progressive, grey or YCbCr 4:2:2, 4:2:0, 4:4:0 or 4:4:4, with or without
  /// Huffman tables. Chroma at full width is averaged to half width, as Picture has it. Levels are full range (JFIF).
  ///
  /// The accurate DCT (JDCT_ISLOW) is used: the fast one saves little and errs in the luma that spots are measured on.
  ///
  /// All of the data is read and checked, whatever rows are decoded.
  ///
  /// @param expected the size the camera was set to; nothing = any size up to kMaxPictureSide_px
  /// @param bands    rows to decode, widened to whole rows of MCUs (8 or 16 px); bands that touch nothing of the
  ///                 picture, or none, mean all of it
  /// @return a view into this decoder, valid until the next call; kCorruptFrame for data that is damaged, ends early,
  ///         has another size than expected, or is of a kind no camera sends
  Result<Picture> decode(std::span<const std::uint8_t> jpeg, std::optional<ImageSize> expected,
                         const RowBands& bands = {});

  /// The coded data of the picture that `decode` returned last, a part of what it was given: two pictures of a camera
  /// that agree in it are one, whatever else their headers count.
  [[nodiscard]] std::span<const std::uint8_t> coded() const { return coded_; }

 private:
  std::array<std::vector<std::uint8_t>, 3> planes_;
  std::span<const std::uint8_t> coded_;
};

}  // namespace tripoint
