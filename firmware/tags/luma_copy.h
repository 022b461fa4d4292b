// The luma of a picture, row after row without gaps, whatever the picture's own layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ports/frame.h"
#include "tags/luma_view.h"

namespace tripoint {

/// Allocates when the size of the pictures changes, otherwise never.
class LumaCopy {
 public:
  /// @param picture  YUYV, planes or GREY; of all rows, not of bands
  void take(const Picture& picture);

  [[nodiscard]] ImageSize size() const { return size_; }
  /// height x width values; the stride is the width.
  [[nodiscard]] std::vector<std::uint8_t>& values() { return values_; }

  [[nodiscard]] double mean() const;
  /// Valid until the next picture is taken.
  [[nodiscard]] LumaView view() const;

 private:
  ImageSize size_;
  std::vector<std::uint8_t> values_;
};

}  // namespace tripoint
