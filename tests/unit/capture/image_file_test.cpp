#include "capture/image_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "scratch_folder.h"
#include "test_pictures.h"

namespace tripoint {
namespace {

class ImageFileTest : public testing::Test {
 protected:
  void write(const std::vector<std::uint8_t>& bytes) const {
    std::ofstream file(path_, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  test::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "image";
};

TEST_F(ImageFileTest, AJpegIsKnownByItsBytes) {
  write(test::jpeg_of(test::smooth_picture({32, 16}), {}));
  const auto image = LoadedImage::load(path_);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->picture().size, (ImageSize{32, 16}));
  EXPECT_FALSE(image->picture().interleaved_yuyv);
}

TEST_F(ImageFileTest, APngIsKnownByItsBytesAndOutlivesAMove) {
  write(test::png_of({2, 1}, true, {255, 0, 0, 255, 0, 0}));
  auto image = LoadedImage::load(path_);
  ASSERT_TRUE(image) << image.error().message;
  const LoadedImage moved = std::move(*image);
  EXPECT_TRUE(moved.picture().interleaved_yuyv);
  EXPECT_EQ(moved.picture().luma.at(1, 0), 76);
  EXPECT_EQ(moved.picture().v.at(0, 0), 255);
}

TEST_F(ImageFileTest, AMissingFileIsNamed) {
  const auto image = LoadedImage::load(path_);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kCannotRead);
  EXPECT_NE(image.error().message.find(path_.string()), std::string::npos);
}

TEST_F(ImageFileTest, AFolderIsNotAFile) {
  const auto image = LoadedImage::load(folder_.path());
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kCannotRead);
}

TEST_F(ImageFileTest, ADamagedFileIsNamed) {
  write({1, 2, 3});
  const auto image = LoadedImage::load(path_);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kCorruptFrame);
  EXPECT_NE(image.error().message.find(path_.string()), std::string::npos);
}

TEST_F(ImageFileTest, AFileBeyondTheLimitIsNotRead) {
  write(std::vector<std::uint8_t>(11));
  EXPECT_TRUE(bytes_of_file(path_, 11));
  EXPECT_FALSE(bytes_of_file(path_, 10));
}

}  // namespace
}  // namespace tripoint
