#include "explain/png_encoder.h"

#include <gtest/gtest.h>
#include <png.h>

namespace tripoint {
namespace {

RgbImage decoded(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0) << image.message;
  EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  RgbImage read{{static_cast<int>(image.width), static_cast<int>(image.height)},
                std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, read.values.data(), 0, nullptr), 0) << image.message;
  return read;
}

TEST(PngEncoderTest, LibpngReadsBackEveryValue) {
  RgbImage image = plain_image({37, 23}, {1, 2, 3});
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<std::uint8_t>(i * i % 251);
  const auto png = png_of(image);
  ASSERT_TRUE(png);
  const RgbImage read = decoded(*png);
  EXPECT_EQ(read.size, image.size);
  EXPECT_EQ(read.values, image.values);
}

TEST(PngEncoderTest, OnePixelIsAPicture) {
  const auto png = png_of(plain_image({1, 1}, {255, 0, 9}));
  ASSERT_TRUE(png);
  EXPECT_EQ(decoded(*png).at(0, 0), (Colour{255, 0, 9}));
}

TEST(PngEncoderTest, AnEmptyImageIsABug) { EXPECT_DEATH(static_cast<void>(png_of(RgbImage{})), "bug"); }

}  // namespace
}  // namespace tripoint
