#include "capture/mjpeg_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>

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

RowBands bands(std::initializer_list<RowBand> some) {
  RowBands all;
  for (const RowBand& band : some) all.push_back(band);
  return all;
}

/// A picture with something in every block.
test::SmoothPicture busy_picture(ImageSize size) {
  const auto level = [](int x, int y) { return 40 + (x * 7 + y * 13 + x * y) % 170; };
  return {size, level, level, level};
}

bool in_bands(const RowBands& some, int v_px) {
  return std::any_of(some.begin(), some.end(),
                     [v_px](const RowBand& band) { return v_px >= band.top_px && v_px < band.bottom_px; });
}

/// Values of both pictures in the rows that `part` holds agree to the bit.
void expect_same_rows(const Picture& part, const Picture& whole) {
  for (int y = 0; y < part.size.height_px; ++y) {
    if (!in_bands(part.bands, y)) continue;
    const int row = part.chroma_rows_halved ? y / 2 : y;
    for (int x = 0; x < part.size.width_px; ++x) {
      ASSERT_EQ(part.luma.at(x, y), whole.luma.at(x, y)) << x << "," << y;
      ASSERT_EQ(part.v.at(x / 2, row), whole.v.at(x / 2, row)) << x << "," << y;
      ASSERT_EQ(part.u.at(x / 2, row), whole.u.at(x / 2, row)) << x << "," << y;
    }
  }
}

void expect_bands_as_in_whole(const JpegKind& kind) {
  const auto jpeg = jpeg_of(busy_picture({80, 96}), kind);
  MjpegDecoder whole;
  MjpegDecoder part;
  const auto all = whole.decode(jpeg, std::nullopt);
  const auto some = part.decode(jpeg, std::nullopt, bands({{17, 30}, {64, 66}}));
  ASSERT_TRUE(all && some);
  ASSERT_EQ(some->bands.size(), 2U);
  EXPECT_EQ(some->bands[0], (RowBand{16, 32}));
  EXPECT_TRUE(all->bands.empty());
  expect_same_rows(*some, *all);
}

TEST(MjpegDecoderTest, RowsOfABandAreThoseOfTheWholePicture) {
  expect_bands_as_in_whole({.luma_h = 2, .luma_v = 1, .quality = 85});
  expect_bands_as_in_whole({.luma_h = 2, .luma_v = 2, .quality = 85});
  expect_bands_as_in_whole({.luma_h = 1, .luma_v = 2, .quality = 85});
  expect_bands_as_in_whole({.luma_h = 1, .luma_v = 1, .quality = 85});
  expect_bands_as_in_whole({.progressive = true, .quality = 85});
}

TEST(MjpegDecoderTest, RowsOutsideTheBandsKeepTheirOldValues) {
  const auto flat = [](int level) {
    const auto same = [level](int, int) { return level; };
    return jpeg_of({{64, 48}, same, same, same}, {});
  };
  MjpegDecoder decoder;
  ASSERT_TRUE(decoder.decode(flat(50), kSize));
  const auto picture = decoder.decode(flat(200), kSize, bands({{16, 24}}));
  ASSERT_TRUE(picture);
  for (const int old : {0, 15, 24, 47}) EXPECT_NEAR(picture->luma.at(30, old), 50, 1) << old;
  for (const int fresh : {16, 23}) EXPECT_NEAR(picture->luma.at(30, fresh), 200, 1) << fresh;
}

TEST(MjpegDecoderTest, NeighbouringBandsBecomeOneAndTheLastEndsWithThePicture) {
  MjpegDecoder decoder;
  const auto picture = decoder.decode(jpeg_of(smooth_picture({64, 44}), {}), std::nullopt,
                                      bands({{30, 60}, {8, 16}, {16, 17}, {12, 30}}));
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->bands.size(), 1U);
  EXPECT_EQ(picture->bands[0], (RowBand{8, 44}));
}

TEST(MjpegDecoderTest, BandsBesideThePictureMeanAllOfIt) {
  MjpegDecoder decoder;
  const auto truth = smooth_picture(kSize);
  const auto picture = decoder.decode(jpeg_of(truth, {}), kSize, bands({{48, 90}, {-20, 0}, {9, 3}}));
  ASSERT_TRUE(picture);
  EXPECT_TRUE(picture->bands.empty());
  expect_shows(*picture, truth);
}

// What lies outside the bands is not shown, but a frame that lost a packet there is no good frame.
TEST(MjpegDecoderTest, EveryTruncationIsCorruptWhateverTheBands) {
  const auto jpeg = jpeg_of(busy_picture(kSize), {.quality = 85});
  MjpegDecoder decoder;
  for (std::size_t length = 0; length < jpeg.size(); ++length) {
    EXPECT_FALSE(decoder.decode(std::span(jpeg).first(length), kSize, bands({{0, 8}}))) << length;
  }
}

// Both ways refuse the same data: all of it is read. One byte in turn is changed, so that a code becomes another.
TEST(MjpegDecoderTest, BandsBearNoDamageThatAWholePictureDoesNot) {
  const auto jpeg = jpeg_of(busy_picture(kSize), {.quality = 85});
  MjpegDecoder whole;
  MjpegDecoder part;
  int refused = 0;
  for (std::size_t at = 0; at < jpeg.size(); ++at) {
    auto damaged = jpeg;
    damaged[at] ^= 0x5AU;
    const bool good = whole.decode(damaged, kSize).has_value();
    ASSERT_EQ(part.decode(damaged, kSize, bands({{0, 8}})).has_value(), good) << at;
    refused += good ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

TEST(MjpegDecoderTest, TheCodedDataIsTheSameWhateverIsDecodedAndWhateverTheHeaderSays) {
  const auto jpeg = jpeg_of(busy_picture(kSize), {.quality = 85});
  auto counted = jpeg;  // a comment that counts frames, after the start marker
  const std::array<std::uint8_t, 8> comment{0xFF, 0xFE, 0, 6, 'n', 'o', '.', '7'};
  counted.insert(counted.begin() + 2, comment.begin(), comment.end());
  counted.resize(counted.size() + 64, 0);  // and a transfer's padding
  MjpegDecoder one;
  MjpegDecoder other;
  ASSERT_TRUE(one.decode(jpeg, kSize));
  ASSERT_TRUE(other.decode(counted, kSize, bands({{8, 16}})));
  ASSERT_GT(one.coded().size(), 500U);
  EXPECT_TRUE(std::ranges::equal(one.coded(), other.coded()));
  ASSERT_FALSE(one.decode(std::span(jpeg).first(jpeg.size() - 9), kSize));
  EXPECT_TRUE(one.coded().empty());
}

}  // namespace
}  // namespace tripoint
