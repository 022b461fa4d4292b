// Notices a camera that hands out old pictures with fresh time stamps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ports/frame.h"

namespace tripoint {

/// Pictures that are remembered: no V4L2 driver has more buffers to go round in (VIDEO_MAX_FRAME).
inline constexpr std::size_t kPicturesRemembered = 32;

/// Two pictures of a sensor differ by its noise, so one that equals an earlier one to the bit is that earlier one. The
/// whole luma plane is compared (in YUYV its chroma too), of a JPEG all of its coded data: what else it carries may
/// count on while its picture stands. Different pictures are taken for equal only by a collision of 64-bit hashes.
class RepeatCheck {
 public:
  /// Reads every byte compared once, which is little beside finding spots or decoding a JPEG.
  ///
  /// @return true when the picture equals one of the last kPicturesRemembered different ones
  bool repeats(const Picture& picture);
  /// The same for a JPEG, of which not every row need be decoded.
  ///
  /// @param coded as MjpegDecoder gives it
  bool repeats(std::span<const std::uint8_t> coded, ImageSize size);

 private:
  bool remember(std::uint64_t hash);

  std::array<std::uint64_t, kPicturesRemembered> seen_{};  // newest first; one that comes again is the newest again
};

}  // namespace tripoint
