// A calibration file as the interface document shows it, and ways to damage it.
#pragma once

#include <string>
#include <string_view>

namespace tripoint::testing {

inline constexpr std::string_view kCalibration = R"(format = "tripoint-calibration/1"
created = 2026-11-22T12:00:00Z
verified = true
[cameras.left]
serial = "LEFT-001"
port = "1-1"
width_px = 640
height_px = 480
focal_px = [628.0, 628.6]
center_px = [322.3, 237.8]
distortion = [-0.30, 0.10, 5e-4, -3e-4, 0.0]
[cameras.right]
serial = ""
port = "1-2"
width_px = 320
height_px = 240
focal_px = [626.1, 626.7]
center_px = [317.1, 243.5]
distortion = [-0.28, 0.09, -4e-4, 6e-4, 0.0]
[right_from_left]
rotation_rad = [0.00698, 0.17453, 0.01222]
translation_mm = [-99.6, 0.2, 8.7]
[quality]
rms_px = 0.07
board = "chessboard:9x6:24.23"
[[quality.lengths]]
nominal_mm = 200.0
measured_mm = 200.03
uncertainty_mm = 0.05
)";

/// The text with the first `from` replaced.
inline std::string with(std::string_view from, std::string_view to, std::string_view text = kCalibration) {
  std::string changed{text};
  const std::size_t at = changed.find(from);
  return at == std::string::npos ? "text not found" : changed.replace(at, from.size(), to);
}

}  // namespace tripoint::testing
