// Notices a camera that hands out the same picture again and again with fresh time stamps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace tripoint {

/// Reads a seventh of each picture (about 10 us at 640x480 YUYV); only when that seventh has not changed is the whole
/// picture read, and only two equal whole pictures are called a repeat. So the second copy of a picture is the first
/// to be called one, and a difference of one bit anywhere is never called a repeat but for a 64-bit hash collision.
class RepeatCheck {
 public:
  /// @param data the picture as the camera delivered it, packed or compressed
  /// @return true when the picture before was the same to the bit, and the one before it in the seventh that was read
  bool repeats(std::span<const std::uint8_t> data);

 private:
  std::optional<std::uint64_t> sample_;
  std::optional<std::uint64_t> whole_;
};

}  // namespace tripoint
