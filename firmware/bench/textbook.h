// What a good engineer writes with OpenCV to find red spots: the baseline of every "_vs_textbook" figure.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "values/pixel.h"

namespace tripoint::bench {

/// YUYV to BGR to HSV, the two red ranges of hue, open, contours, moments. Its matrices are reused between pictures.
class Textbook {
 public:
  Textbook();

  /// Centres in px of every red contour of more than 3 px area; valid until the next call.
  const std::vector<cv::Point2d>& spots(const std::uint8_t* yuyv, ImageSize size);
  /// The same for a picture that is BGR already.
  const std::vector<cv::Point2d>& spots_of_bgr(const cv::Mat& bgr);

 private:
  cv::Mat kernel_, bgr_, hsv_, low_hue_, high_hue_, red_, opened_;
  std::vector<std::vector<cv::Point>> contours_;
  std::vector<cv::Point2d> spots_;
};

}  // namespace tripoint::bench
