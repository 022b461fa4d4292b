#include "bench/textbook.h"

#include <opencv2/imgproc.hpp>

namespace tripoint::bench {

Textbook::Textbook() : kernel_(cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3})) {}

const std::vector<cv::Point2d>& Textbook::spots(const std::uint8_t* yuyv, ImageSize size) {
  const cv::Mat frame(size.height_px, size.width_px, CV_8UC2, const_cast<std::uint8_t*>(yuyv));
  cv::cvtColor(frame, bgr_, cv::COLOR_YUV2BGR_YUYV);
  return spots_of_bgr(bgr_);
}

const std::vector<cv::Point2d>& Textbook::spots_of_bgr(const cv::Mat& bgr) {
  cv::cvtColor(bgr, hsv_, cv::COLOR_BGR2HSV);
  cv::inRange(hsv_, cv::Scalar(0, 100, 100), cv::Scalar(10, 255, 255), low_hue_);
  cv::inRange(hsv_, cv::Scalar(160, 100, 100), cv::Scalar(179, 255, 255), high_hue_);
  cv::bitwise_or(low_hue_, high_hue_, red_);
  cv::morphologyEx(red_, opened_, cv::MORPH_OPEN, kernel_);
  cv::findContours(opened_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  spots_.clear();
  for (const auto& contour : contours_) {
    const cv::Moments moments = cv::moments(contour);
    if (moments.m00 > 3.0) spots_.emplace_back(moments.m10 / moments.m00, moments.m01 / moments.m00);
  }
  return spots_;
}

}  // namespace tripoint::bench
