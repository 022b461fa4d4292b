#include "capture/mjpeg_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "test_pictures.h"

namespace tripoint {
namespace {

using test::jpeg_of;
using test::JpegKind;
using test::smooth_picture;

constexpr ImageSize kSize{64, 48};

// Quality 100 quantises each coefficient by 1: error below 1/2 in each of 64, RMS 0.29 of a level, 5 sigma = 1.5;
// rounding on both sides adds 1.
constexpr int kLumaTolerance = 2;
// The chroma slopes are 1/8 level a pixel: averaging two neighbours moves them by less than 1.
constexpr int kChromaTolerance = 3;

void expect_shows(const Picture& picture, const test::SmoothPicture& truth) {
  ASSERT_EQ(picture.size, truth.size);
  for (int y = 0; y < truth.size.height_px; ++y) {
    for (int x = 0; x < truth.size.width_px; ++x) {
      ASSERT_NEAR(picture.luma.at(x, y), truth.luma(x, y), kLumaTolerance) << x << "," << y;
      if (picture.u.data == nullptr) continue;
      const int row = picture.chroma_rows_halved ? y / 2 : y;
      ASSERT_NEAR(picture.u.at(x / 2, row), truth.u(x, y), kChromaTolerance) << x << "," << y;
      ASSERT_NEAR(picture.v.at(x / 2, row), truth.v(x, y), kChromaTolerance) << x << "," << y;
    }
  }
}

void expect_decodes(ImageSize size, const JpegKind& kind) {
  const auto truth = smooth_picture(size);
  MjpegDecoder decoder;
  const auto picture = decoder.decode(jpeg_of(truth, kind), size);
  ASSERT_TRUE(picture) << picture.error().message;
  expect_shows(*picture, truth);
}

ErrorCode refusal(std::span<const std::uint8_t> jpeg, std::optional<ImageSize> expected) {
  MjpegDecoder decoder;
  const auto picture = decoder.decode(jpeg, expected);
  EXPECT_FALSE(picture);
  return picture ? ErrorCode::kDeviceFault : picture.error().code;
}

TEST(MjpegDecoderTest, Planes422AreThoseThatWereEncoded) { expect_decodes(kSize, {.luma_h = 2, .luma_v = 1}); }
TEST(MjpegDecoderTest, Planes420AreThoseThatWereEncoded) { expect_decodes(kSize, {.luma_h = 2, .luma_v = 2}); }
TEST(MjpegDecoderTest, Planes440AreThoseThatWereEncoded) { expect_decodes(kSize, {.luma_h = 1, .luma_v = 2}); }
TEST(MjpegDecoderTest, Planes444AreHalvedToWhatPictureHolds) { expect_decodes(kSize, {.luma_h = 1, .luma_v = 1}); }
TEST(MjpegDecoderTest, OddSizesKeepTheirLastColumnAndRow) {
  expect_decodes({37, 21}, {.luma_h = 2, .luma_v = 2});
  expect_decodes({37, 21}, {.luma_h = 1, .luma_v = 1});
}
TEST(MjpegDecoderTest, AProgressivePictureIsDecoded) { expect_decodes(kSize, {.progressive = true}); }

TEST(MjpegDecoderTest, AGreyPictureHasNoChroma) {
  MjpegDecoder decoder;
  const auto truth = smooth_picture(kSize);
  const auto picture = decoder.decode(jpeg_of(truth, {.grey = true}), kSize);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->u.data, nullptr);
  EXPECT_EQ(picture->v.data, nullptr);
  expect_shows(*picture, truth);
}

TEST(MjpegDecoderTest, MissingHuffmanTablesAreTheStandardOnes) { expect_decodes(kSize, {.without_tables = true}); }

TEST(MjpegDecoderTest, TablesOfOnePictureDoNotServeTheNext) {
  const auto truth = smooth_picture(kSize);
  MjpegDecoder decoder;
  ASSERT_TRUE(decoder.decode(jpeg_of(truth, {.progressive = true}), kSize));  // has tables of its own making
  const auto picture = decoder.decode(jpeg_of(truth, {.without_tables = true}), kSize);
  ASSERT_TRUE(picture) << picture.error().message;
  expect_shows(*picture, truth);
}

TEST(MjpegDecoderTest, PlanesAreNotMovedFromPictureToPicture) {
  MjpegDecoder decoder;
  const auto jpeg = jpeg_of(smooth_picture(kSize), {});
  const auto first = decoder.decode(jpeg, kSize);
  const auto second = decoder.decode(jpeg, kSize);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->luma.data, second->luma.data);
}

TEST(MjpegDecoderTest, EveryTruncationIsCorrupt) {
  const auto jpeg = jpeg_of(smooth_picture(kSize), {});
  for (std::size_t length = 0; length < jpeg.size(); ++length) {
    EXPECT_EQ(refusal(std::span(jpeg).first(length), kSize), ErrorCode::kCorruptFrame) << length;
  }
}

TEST(MjpegDecoderTest, TrailingPaddingOfATransferIsIgnored) {
  auto jpeg = jpeg_of(smooth_picture(kSize), {});
  jpeg.resize(jpeg.size() + 512, 0);
  MjpegDecoder decoder;
  EXPECT_TRUE(decoder.decode(jpeg, kSize));
}

/// Zeros before the end marker: `count` of them.
std::vector<std::uint8_t> padded_jpeg(std::size_t count) {
  auto jpeg = jpeg_of(smooth_picture(kSize), {});
  jpeg.insert(jpeg.end() - 2, count, 0);
  return jpeg;
}

TEST(MjpegDecoderTest, ALittlePaddingBeforeAMarkerIsBorne) {
  MjpegDecoder decoder;
  EXPECT_TRUE(decoder.decode(padded_jpeg(32), kSize));
}

TEST(MjpegDecoderTest, MoreDataThanThePictureNeedsIsCorrupt) {
  EXPECT_EQ(refusal(padded_jpeg(64), kSize), ErrorCode::kCorruptFrame);
}

TEST(MjpegDecoderTest, BytesMissingInTheMiddleAreCorrupt) {
  auto jpeg = jpeg_of(smooth_picture({320, 240}), {});
  const auto middle = jpeg.begin() + static_cast<std::ptrdiff_t>(jpeg.size() / 2);
  jpeg.erase(middle, middle + 512);
  EXPECT_EQ(refusal(jpeg, ImageSize{320, 240}), ErrorCode::kCorruptFrame);
}

TEST(MjpegDecoderTest, AnotherSizeThanTheCameraWasSetToIsCorrupt) {
  const auto jpeg = jpeg_of(smooth_picture(kSize), {});
  EXPECT_EQ(refusal(jpeg, ImageSize{64, 56}), ErrorCode::kCorruptFrame);
}

TEST(MjpegDecoderTest, SizesUpToTheLimitAreTakenWhenNoneIsExpected) {
  const auto flat = [](int, int) { return 128; };
  const auto of_width = [&](int width_px) { return jpeg_of({{width_px, 8}, flat, flat, flat}, {}); };
  MjpegDecoder decoder;
  EXPECT_TRUE(decoder.decode(of_width(4096), std::nullopt));
  EXPECT_EQ(refusal(of_width(4097), std::nullopt), ErrorCode::kCorruptFrame);
}

TEST(MjpegDecoderTest, QuarterWidthChromaIsRefused) {
  EXPECT_EQ(refusal(jpeg_of(smooth_picture(kSize), {.luma_h = 4, .luma_v = 1}), kSize), ErrorCode::kCorruptFrame);
}

TEST(MjpegDecoderTest, MoreScansThanAnyEncoderWritesAreRefused) {
  const auto jpeg = jpeg_of(smooth_picture(kSize), {.many_scans = true});
  MjpegDecoder decoder;
  const auto picture = decoder.decode(jpeg, kSize);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().message.find("scans"), std::string::npos) << picture.error().message;
}

}  // namespace
}  // namespace tripoint
