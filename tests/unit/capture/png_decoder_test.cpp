#include "capture/png_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "test_pictures.h"

namespace tripoint {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// One row of two equal pixels, packed.
Bytes packed_colour(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  const auto picture = picture_from_png(test::png_of({2, 1}, true, {red, green, blue, red, green, blue}));
  EXPECT_TRUE(picture);
  return picture ? picture->data : Bytes{};
}

// Values of BT.601 full range from the published tables of JFIF: primaries and their complements.
TEST(PngDecoderTest, WhiteAndBlackHaveNoColour) {
  EXPECT_EQ(packed_colour(255, 255, 255), (Bytes{255, 128, 255, 128}));
  EXPECT_EQ(packed_colour(0, 0, 0), (Bytes{0, 128, 0, 128}));
}
TEST(PngDecoderTest, RedIsThatOfJfif) { EXPECT_EQ(packed_colour(255, 0, 0), (Bytes{76, 85, 76, 255})); }
TEST(PngDecoderTest, GreenIsThatOfJfif) { EXPECT_EQ(packed_colour(0, 255, 0), (Bytes{150, 44, 150, 21})); }
TEST(PngDecoderTest, BlueIsThatOfJfif) { EXPECT_EQ(packed_colour(0, 0, 255), (Bytes{29, 255, 29, 107})); }

TEST(PngDecoderTest, ChromaIsTheMeanOfAPair) {
  const auto picture = picture_from_png(test::png_of({2, 1}, true, {255, 0, 0, 255, 255, 255}));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->data, (Bytes{76, 106, 255, 192}));  // (84.9 + 128) / 2 and (255.5 + 128) / 2
}

TEST(PngDecoderTest, AnOddWidthRepeatsTheLastPixelInItsPair) {
  const auto picture = picture_from_png(test::png_of({3, 1}, true, {0, 0, 0, 0, 0, 0, 255, 0, 0}));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->stride_bytes, 8U);
  EXPECT_EQ(picture->data, (Bytes{0, 128, 0, 128, 76, 85, 76, 255}));
}

TEST(PngDecoderTest, AGreyFileStaysGrey) {
  const auto picture = picture_from_png(test::png_of({3, 2}, false, {1, 2, 3, 4, 5, 6}));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->format, PixelFormat::kGrey);
  EXPECT_EQ(picture->data, (Bytes{1, 2, 3, 4, 5, 6}));
}

TEST(PngDecoderTest, EveryTruncationOfTheDataIsCorrupt) {
  Bytes values(32 * 32 * 3);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * i % 251);
  const Bytes png = test::png_of({32, 32}, true, values);
  constexpr std::size_t kEndChunk_bytes = 12;  // IEND alone may be missing: every pixel was there
  for (std::size_t length = 0; length < png.size() - kEndChunk_bytes - 4; ++length) {
    const auto picture = picture_from_png(std::span(png).first(length));
    ASSERT_FALSE(picture) << length;
    ASSERT_EQ(picture.error().code, ErrorCode::kCorruptFrame);
  }
}

TEST(PngDecoderTest, AWidthBeyondTheLimitIsRefusedBeforeMemoryIsTaken) {
  EXPECT_TRUE(picture_from_png(test::png_of({4096, 1}, false, Bytes(4096))));
  EXPECT_FALSE(picture_from_png(test::png_of({4097, 1}, false, Bytes(4097))));
}

}  // namespace
}  // namespace tripoint
