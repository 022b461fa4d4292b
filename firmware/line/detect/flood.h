// The connected area around a peak that is brighter than a level.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "line/detect/spot_window.h"

namespace tripoint {

/// Moments of an area, in window coordinates.
struct Area {
  int pixels = 0;
  double column = 0.0;  ///< centre
  double row = 0.0;
  double long_axis_px = 0.0;  ///< standard deviations, with the pixel's own 1/12
  double short_axis_px = 0.0;
  bool leaves_part = false;    ///< reached the border of the part: the rest is not known
  bool cut_by_border = false;  ///< touches the end of the picture

  [[nodiscard]] double aspect() const { return long_axis_px / short_axis_px; }
  [[nodiscard]] double radius_px() const;  ///< of the circle of the same area
};

class Flood {
 public:
  /// The 4-connected area of S >= level around window index `seed`, as far as it keeps within a part of the window.
  Area spread(const SpotWindow& window, const SpotWindow::Part& part, std::size_t seed, int level);

  /// Whether a pixel belongs to the area of the last `spread`.
  [[nodiscard]] bool holds(std::size_t index) const { return marked_[index] != 0; }
  /// The window indices of that area.
  [[nodiscard]] std::span<const std::uint16_t> area() const { return {reached_.data(), pixels_}; }

 private:
  std::array<std::uint8_t, SpotWindow::kPixels> marked_{};
  std::array<std::uint16_t, SpotWindow::kPixels> reached_{};
  std::size_t pixels_ = 0;
};

}  // namespace tripoint
