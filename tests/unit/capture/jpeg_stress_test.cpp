// Real and broken JPEGs made by others.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "capture/image_file.h"
#include "test_pictures.h"

#ifdef TRIPOINT_HAVE_OPENCV

#include <opencv2/imgcodecs.hpp>
#endif

namespace tripoint {
namespace {

class JpegStressTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is absent; set TRIPOINT_SHARED";
  }
  std::filesystem::path folder_ = test::shared_data() / "jpeg_stress";
};

TEST_F(JpegStressTest, ARealWebcamFrameWithoutHuffmanTablesIsDecoded) {
  const auto image = LoadedImage::load(folder_ / "mjpeg.jpg");
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->picture().size, (ImageSize{960, 720}));
  EXPECT_NE(image->picture().u.data, nullptr);
}

TEST_F(JpegStressTest, LumaOfTheWebcamFrameIsOpenCvs) {
#ifdef TRIPOINT_HAVE_OPENCV
  const cv::Mat truth = cv::imread((folder_ / "mjpeg.jpg").string(), cv::IMREAD_GRAYSCALE);
  ASSERT_FALSE(truth.empty());
  const auto image = LoadedImage::load(folder_ / "mjpeg.jpg");
  ASSERT_TRUE(image) << image.error().message;
  int worst = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      worst = std::max(worst, std::abs(truth.at<std::uint8_t>(y, x) - image->picture().luma.at(x, y)));
    }
  }
  EXPECT_LE(worst, 1);
#else
  GTEST_SKIP() << "OpenCV's imgcodecs was not found when building: see deploy/dev/packages.txt";
#endif
}

/// Every value is read, so that a sanitizer sees a plane that is too short.
std::uint64_t sum_of(const Picture& picture) {
  std::uint64_t sum = 0;
  for (int y = 0; y < picture.size.height_px; ++y) {
    for (int x = 0; x < picture.size.width_px; ++x) {
      sum += picture.luma.at(x, y);
      if (picture.u.data == nullptr) continue;
      const int row = picture.chroma_rows_halved ? y / 2 : y;
      sum += picture.u.at(x / 2, row);
      sum += picture.v.at(x / 2, row);
    }
  }
  return sum;
}

TEST_F(JpegStressTest, BrokenPicturesAreRefusedOrWhole) {
  int decoded = 0;
  int refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    if (entry.path().extension() != ".jpg") continue;
    const auto image = LoadedImage::load(entry.path());
    if (image) {
      ++decoded;
      EXPECT_GT(sum_of(image->picture()), 0U) << entry.path();
    } else {
      ++refused;
      EXPECT_EQ(image.error().code, ErrorCode::kCorruptFrame) << entry.path();
    }
  }
  std::printf("decoded %d, refused %d\n", decoded, refused);
  EXPECT_GE(decoded, 1);   // the webcam frame
  EXPECT_GE(refused, 40);  // most of the others are damaged by intent
}

}  // namespace
}  // namespace tripoint
