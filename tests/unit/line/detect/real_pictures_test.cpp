// Pictures of other people that show tags and boards but no red LED.
#include <gtest/gtest.h>

#ifdef TRIPOINT_HAS_IMGCODECS
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "bench/painter.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

fs::path shared_data() {
  const char* given = std::getenv("TRIPOINT_SHARED");
  return (given != nullptr ? fs::path(given) : fs::path(TRIPOINT_TESTS_DIR) / "../../shared") / "data";
}

std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

/// BT.601 limited range, chroma averaged over two pixels.
bench::YuyvPicture yuyv_of(const cv::Mat& bgr) {
  bench::YuyvPicture picture{.size = {bgr.cols & ~1, bgr.rows}, .bytes = {}};
  for (int v = 0; v < picture.size.height_px; ++v) {
    for (int u = 0; u < picture.size.width_px; u += 2) {
      const auto& a = bgr.at<cv::Vec3b>(v, u);
      const auto& b = bgr.at<cv::Vec3b>(v, u + 1);
      const auto luma = [](const cv::Vec3b& p) { return byte_of(16.0 + 0.257 * p[2] + 0.504 * p[1] + 0.098 * p[0]); };
      const double blue = 0.5 * (a[0] + b[0]);
      const double green = 0.5 * (a[1] + b[1]);
      const double red = 0.5 * (a[2] + b[2]);
      picture.bytes.push_back(luma(a));
      picture.bytes.push_back(byte_of(128.0 - 0.148 * red - 0.291 * green + 0.439 * blue));
      picture.bytes.push_back(luma(b));
      picture.bytes.push_back(byte_of(128.0 + 0.439 * red - 0.368 * green - 0.071 * blue));
    }
  }
  return picture;
}

void expect_nothing_in(const std::string& folder) {
  const fs::path path = shared_data() / folder;
  if (!fs::is_directory(path)) GTEST_SKIP() << "no such folder: " << path << "; set TRIPOINT_SHARED";
  int pictures = 0;
  LedDetector detector{LedDetectorSettings{}};
  for (const auto& entry : fs::directory_iterator(path)) {
    const cv::Mat bgr = cv::imread(entry.path().string(), cv::IMREAD_COLOR);
    if (bgr.empty()) continue;
    ++pictures;
    const auto picture = yuyv_of(bgr);
    const Detection detection = detector.detect(picture.view(), {});
    for (const ImagePoint& point : detection.points) {
      ADD_FAILURE() << entry.path().filename() << ": a point at " << point.at.u_px << ", " << point.at.v_px;
    }
  }
  EXPECT_GT(pictures, 0);
}

TEST(RealPicturesTest, NothingInSwarmathonTags) { expect_nothing_in("apriltag_swarmathon"); }
TEST(RealPicturesTest, NothingInDuckietownTags) { expect_nothing_in("apriltag_duckietown"); }
TEST(RealPicturesTest, NothingInAprilGrids) { expect_nothing_in("aprilgrid"); }
TEST(RealPicturesTest, NothingInChessboards) { expect_nothing_in("stereo_opencv_chessboard"); }
TEST(RealPicturesTest, NothingInCharucoBoards) { expect_nothing_in("charuco_mono_lifecam1280"); }

TEST(RealPicturesTest, ExactlyTheRedSpotAmongRedThings) {
  const fs::path path = shared_data() / "red_spot_scenes" / "4.jpg";
  const cv::Mat bgr = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (bgr.empty()) GTEST_SKIP() << "no such file: " << path << "; set TRIPOINT_SHARED";
  LedDetectorSettings settings;
  settings.min_emission = -0.1;  // a spot on a lit wall
  LedDetector detector{settings};
  const auto picture = yuyv_of(bgr);
  const Detection detection = detector.detect(picture.view(), {});
  ASSERT_EQ(detection.points.size(), 1U);
  // Its place is known by inspection to a few pixels.
  EXPECT_NEAR(detection.points[0].at.u_px, 1611.0, 4.0);
  EXPECT_NEAR(detection.points[0].at.v_px, 1153.0, 4.0);
}

}  // namespace
}  // namespace tripoint
#else
TEST(RealPicturesTest, NeedsImgcodecs) {
  GTEST_SKIP() << "built without OpenCV imgcodecs: real pictures were not looked at";
}
#endif
