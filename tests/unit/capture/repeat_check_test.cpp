#include "capture/repeat_check.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tripoint {
namespace {

constexpr ImageSize kSize{640, 480};

using Pixels = std::vector<std::uint8_t>;

Picture yuyv(const Pixels& pixels, ImageSize size = kSize) {
  return picture_of({.format = PixelFormat::kYuyv,
                     .size = size,
                     .stride_bytes = static_cast<std::size_t>(size.width_px) * 2,
                     .data = pixels});
}

Picture grey(const Pixels& pixels, ImageSize size, std::size_t stride_bytes) {
  return picture_of({.format = PixelFormat::kGrey, .size = size, .stride_bytes = stride_bytes, .data = pixels});
}

Pixels noise(std::mt19937& random, ImageSize size = kSize) {
  Pixels pixels(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 2);
  for (auto& value : pixels) value = static_cast<std::uint8_t>(random());
  return pixels;
}

TEST(RepeatCheckTest, EveryCopyIsARepeatUntilANewPictureComes) {
  std::mt19937 random(1);
  const Pixels frozen = noise(random);
  const Pixels fresh = noise(random);
  RepeatCheck check;
  EXPECT_FALSE(check.repeats(yuyv(frozen)));
  EXPECT_TRUE(check.repeats(yuyv(frozen)));
  EXPECT_TRUE(check.repeats(yuyv(frozen)));
  EXPECT_FALSE(check.repeats(yuyv(fresh)));
}

TEST(RepeatCheckTest, ARoundOfThirtyTwoPicturesIsRecognizedAndOneOfThirtyThreeIsNot) {
  std::mt19937 random(2);
  const ImageSize size{32, 16};
  for (const std::size_t length : {kPicturesRemembered, kPicturesRemembered + 1}) {
    std::vector<Pixels> round;
    for (std::size_t i = 0; i < length; ++i) round.push_back(noise(random, size));
    RepeatCheck check;
    for (const Pixels& pixels : round) ASSERT_FALSE(check.repeats(yuyv(pixels, size)));
    for (const Pixels& pixels : round) {
      ASSERT_EQ(check.repeats(yuyv(pixels, size)), length == kPicturesRemembered) << length;
    }
  }
}

TEST(RepeatCheckTest, AStalePictureThatComesAgainAndAgainIsNeverForgotten) {
  std::mt19937 random(3);
  const ImageSize size{32, 16};
  const Pixels stale = noise(random, size);
  RepeatCheck check;
  EXPECT_FALSE(check.repeats(yuyv(stale, size)));
  for (int i = 0; i < 100; ++i) {
    ASSERT_FALSE(check.repeats(yuyv(noise(random, size), size)));
    ASSERT_TRUE(check.repeats(yuyv(stale, size)));
  }
}

/// The worst case: a dark picture in which one bit of one byte has changed.
TEST(RepeatCheckTest, OneBitAnywhereMakesAnotherPicture) {
  std::mt19937 random(4);
  Pixels pixels(std::size_t{640} * 480 * 2, 16);
  for (int trial = 0; trial < 500; ++trial) {
    const std::size_t place = random() % pixels.size();
    const auto bit = static_cast<std::uint8_t>(1U << (random() % 8));
    RepeatCheck check;
    ASSERT_FALSE(check.repeats(yuyv(pixels)));
    pixels[place] = static_cast<std::uint8_t>(pixels[place] ^ bit);
    ASSERT_FALSE(check.repeats(yuyv(pixels))) << "byte " << place << " bit " << int{bit};
  }
}

TEST(RepeatCheckTest, NoiseOfOneLevelIsNeverARepeat) {
  std::mt19937 random(5);
  const ImageSize size{320, 240};
  RepeatCheck check;
  Pixels pixels(std::size_t{320} * 240 * 2);
  for (int i = 0; i < 300; ++i) {
    for (auto& value : pixels) value = static_cast<std::uint8_t>(16 + random() % 2);
    ASSERT_FALSE(check.repeats(yuyv(pixels, size)));
  }
}

TEST(RepeatCheckTest, RowsThatAreNoMultipleOfABlockCountToTheLastPixel) {
  const ImageSize size{67, 3};
  Pixels pixels(std::size_t{67} * 3, 9);
  RepeatCheck check;
  for (int i = 0; i < 4; ++i) {
    pixels.back() = static_cast<std::uint8_t>(i);
    ASSERT_FALSE(check.repeats(grey(pixels, size, 67)));
  }
}

TEST(RepeatCheckTest, WhatStandsBetweenTheRowsIsNotThePicture) {
  const ImageSize size{16, 2};
  Pixels pixels(std::size_t{20} * 2, 9);
  RepeatCheck check;
  EXPECT_FALSE(check.repeats(grey(pixels, size, 20)));
  pixels[18] = 1;
  EXPECT_TRUE(check.repeats(grey(pixels, size, 20)));
}

TEST(RepeatCheckTest, AnotherSizeIsAnotherPicture) {
  const Pixels zeros(256, 0);
  RepeatCheck check;
  EXPECT_FALSE(check.repeats(grey(zeros, {16, 16}, 16)));
  EXPECT_FALSE(check.repeats(grey(zeros, {16, 15}, 16)));
  EXPECT_FALSE(check.repeats(grey(zeros, {15, 16}, 16)));
}

}  // namespace
}  // namespace tripoint
