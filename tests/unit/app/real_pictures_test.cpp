// Pictures of other people, the way `tripointd detect` reads them: tags and boards show no red LED.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "capture/image_file.h"
#include "line/detect/led_detector.h"
#include "places.h"

namespace tripoint {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".jpg" || ending == ".png";
}

void expect_nothing_in(const std::string& folder) {
  const fs::path path = test::shared_folder() / "data" / folder;
  if (!fs::is_directory(path)) GTEST_SKIP() << "no such folder: " << path << "; set TRIPOINT_SHARED";
  int pictures = 0;
  LedDetector detector{LedDetectorSettings{}};
  for (const auto& entry : fs::directory_iterator(path)) {
    if (!is_picture(entry.path())) continue;
    const Result<LoadedImage> image = LoadedImage::load(entry.path());
    ASSERT_TRUE(image) << image.error().message;
    ++pictures;
    if (image->picture().v.data == nullptr) continue;  // grey
    for (const ImagePoint& point : detector.detect(image->picture(), {}).points) {
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

}  // namespace
}  // namespace tripoint
