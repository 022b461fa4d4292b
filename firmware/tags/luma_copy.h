// The luma of a picture, row after row without gaps, whatever the picture's own layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ports/frame.h"
#include "values/linear.h"

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
  /// Luma between the four pixels around a place, pixel centres at integers; nothing outside of the picture.
  [[nodiscard]] std::optional<double> at(const Vec2& place_px) const;

 private:
  ImageSize size_;
  std::vector<std::uint8_t> values_;
};

}  // namespace tripoint
