#include "explain/rgb_image.h"

#include <gtest/gtest.h>

#include <array>

namespace tripoint {
namespace {

constexpr Colour kBlack{0, 0, 0};

/// Two pixels of one colour, packed as YUYV.
RgbImage rgb_of_pair(std::uint8_t luma, std::uint8_t u, std::uint8_t v) {
  const std::array<std::uint8_t, 4> bytes{luma, u, luma, v};
  return rgb_of(picture_of({.format = PixelFormat::kYuyv, .size = {2, 1}, .stride_bytes = 4, .data = bytes}));
}

/// Each level names its pixel.
RgbImage numbered(ImageSize size) {
  RgbImage image = plain_image(size, kBlack);
  for (int y = 0; y < size.height_px; ++y) {
    for (int x = 0; x < size.width_px; ++x) {
      const auto level = static_cast<std::uint8_t>(10 * y + x);
      image.set(x, y, {level, level, level});
    }
  }
  return image;
}

void expect_near(Colour seen, Colour expected) {
  EXPECT_NEAR(seen.red, expected.red, 1);
  EXPECT_NEAR(seen.green, expected.green, 1);
  EXPECT_NEAR(seen.blue, expected.blue, 1);
}

// The primaries' levels are those of JFIF's published tables; rounded to whole levels they come back within one.
TEST(RgbImageTest, ThePrimariesOfJfifComeBack) {
  expect_near(rgb_of_pair(76, 85, 255).at(1, 0), {254, 0, 0});
  expect_near(rgb_of_pair(150, 44, 21).at(0, 0), {0, 255, 1});
  expect_near(rgb_of_pair(29, 255, 107).at(0, 0), {0, 0, 254});
  EXPECT_EQ(rgb_of_pair(255, 128, 128).at(0, 0), (Colour{255, 255, 255}));
}

TEST(RgbImageTest, APictureWithoutChromaIsGrey) {
  const std::array<std::uint8_t, 2> bytes{7, 200};
  const RgbImage image =
      rgb_of(picture_of({.format = PixelFormat::kGrey, .size = {2, 1}, .stride_bytes = 2, .data = bytes}));
  EXPECT_EQ(image.at(0, 0), (Colour{7, 7, 7}));
  EXPECT_EQ(image.at(1, 0), (Colour{200, 200, 200}));
}

TEST(RgbImageTest, HalvedChromaRowsServeTwoRows) {
  const std::array<std::uint8_t, 4> luma{76, 76, 76, 76};
  const std::array<std::uint8_t, 1> u{85};
  const std::array<std::uint8_t, 1> v{255};
  const Picture picture{
      .size = {1, 4}, .luma = {luma.data(), 1}, .u = {u.data(), 0}, .v = {v.data(), 0}, .chroma_rows_halved = true};
  expect_near(rgb_of(picture).at(0, 3), {254, 0, 0});
}

TEST(RgbImageTest, ReducedIsTheMeanAndCutsWhatIsLeftOver) {
  const RgbImage image = reduced(numbered({5, 3}), 2);
  EXPECT_EQ(image.size, (ImageSize{2, 1}));
  EXPECT_EQ(image.at(0, 0), (Colour{5, 5, 5}));  // of 0, 1, 10 and 11: 5.5
  EXPECT_EQ(image.at(1, 0), (Colour{7, 7, 7}));
}

TEST(RgbImageTest, EnlargedRepeatsPixels) {
  const RgbImage image = enlarged(numbered({2, 2}), 3);
  EXPECT_EQ(image.size, (ImageSize{6, 6}));
  EXPECT_EQ(image.at(2, 2), (Colour{0, 0, 0}));
  EXPECT_EQ(image.at(3, 2), (Colour{1, 1, 1}));
  EXPECT_EQ(image.at(5, 3), (Colour{11, 11, 11}));
}

TEST(RgbImageTest, BrightenedKeepsBlackAndWhite) {
  RgbImage image = plain_image({3, 1}, kBlack);
  image.set(1, 0, {16, 64, 128});
  image.set(2, 0, {255, 255, 255});
  const RgbImage bright = brightened(image);
  EXPECT_EQ(bright.at(0, 0), kBlack);
  EXPECT_EQ(bright.at(1, 0), (Colour{64, 128, 181}));  // sqrt(255 x)
  EXPECT_EQ(bright.at(2, 0), (Colour{255, 255, 255}));
}

TEST(RgbImageTest, ACutOutBeyondTheBorderHasTheOtherColourThere) {
  constexpr Colour kOther{9, 9, 200};
  const RgbImage image = cut_out(numbered({4, 4}), {0, 3}, 5, kOther);
  EXPECT_EQ(image.size, (ImageSize{5, 5}));
  EXPECT_EQ(image.at(2, 2), (Colour{30, 30, 30}));  // the centre
  EXPECT_EQ(image.at(1, 2), kOther);
  EXPECT_EQ(image.at(2, 3), kOther);
  EXPECT_EQ(image.at(3, 1), (Colour{21, 21, 21}));
}

TEST(RgbImageTest, ACutOutFarOutsideIsAllTheOtherColour) {
  constexpr Colour kOther{9, 9, 200};
  const RgbImage image = cut_out(numbered({4, 4}), {100, -100}, 5, kOther);
  EXPECT_EQ(image.values, plain_image({5, 5}, kOther).values);
}

}  // namespace
}  // namespace tripoint
