// What is asked of a real camera.
#pragma once

#include <filesystem>
#include <string>

#include "ports/frame.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

struct V4l2Settings {
  Side side = Side::kLeft;
  std::filesystem::path node = {};  ///< /dev/videoN
  std::string port = {};            ///< USB port path, for people and the calibration
  std::string serial = {};
  PixelFormat format = PixelFormat::kYuyv;
  ImageSize size{640, 480};
  double rate_hz = 30.0;
  std::chrono::microseconds exposure{2000};
  int gain = 0;
  int white_balance_k = 4500;
  int focus = 0;
  Duration line_time{0};  ///< rolling shutter: row r is exposed r times this later
};

}  // namespace tripoint
