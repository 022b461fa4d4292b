#include "capture/repeat_check.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tripoint {
namespace {

constexpr std::size_t kFrame_bytes = 640 * 480 * 2;

std::vector<std::uint8_t> noisy_frame(std::mt19937& random, std::size_t bytes = kFrame_bytes) {
  std::vector<std::uint8_t> frame(bytes);
  for (auto& value : frame) value = static_cast<std::uint8_t>(random());
  return frame;
}

TEST(RepeatCheckTest, TheSecondCopyOfAPictureIsARepeat) {
  std::mt19937 random(1);
  const auto frame = noisy_frame(random);
  RepeatCheck check;
  EXPECT_FALSE(check.repeats(frame));
  check.repeats(frame);  // the first copy: the whole picture before was not read
  EXPECT_TRUE(check.repeats(frame));
  EXPECT_TRUE(check.repeats(frame));
}

TEST(RepeatCheckTest, ANewPictureEndsTheRepeating) {
  std::mt19937 random(2);
  const auto frame = noisy_frame(random);
  RepeatCheck check;
  for (int i = 0; i < 4; ++i) check.repeats(frame);
  EXPECT_FALSE(check.repeats(noisy_frame(random)));
}

/// The worst case for a sample: a dark picture in which one bit of one byte flickers.
TEST(RepeatCheckTest, OneFlickeringBitAnywhereIsNeverARepeat) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::uint8_t> frame(kFrame_bytes, 16);
    const std::size_t place = random() % kFrame_bytes;
    const auto bit = static_cast<std::uint8_t>(1U << (random() % 8));
    RepeatCheck check;
    for (int i = 0; i < 3; ++i) {
      frame[place] = static_cast<std::uint8_t>(frame[place] ^ bit);
      ASSERT_FALSE(check.repeats(frame)) << "byte " << place << " bit " << int{bit};
    }
  }
}

TEST(RepeatCheckTest, NoiseOfOneLevelIsNeverARepeat) {
  std::mt19937 random(4);
  RepeatCheck check;
  std::vector<std::uint8_t> frame(320 * 240 * 2);
  for (int i = 0; i < 300; ++i) {
    for (auto& value : frame) value = static_cast<std::uint8_t>(16 + random() % 2);
    ASSERT_FALSE(check.repeats(frame));
  }
}

TEST(RepeatCheckTest, LengthsThatAreNoMultipleOfALineCountToTheLastByte) {
  std::vector<std::uint8_t> data(64 * 7 + 5, 9);
  RepeatCheck check;
  for (int i = 0; i < 4; ++i) {
    data.back() = static_cast<std::uint8_t>(i);
    ASSERT_FALSE(check.repeats(data));
  }
}

TEST(RepeatCheckTest, AnotherLengthIsAnotherPicture) {
  const std::vector<std::uint8_t> zeros(200, 0);
  RepeatCheck check;
  check.repeats(std::span(zeros).first(130));
  check.repeats(std::span(zeros).first(130));
  EXPECT_FALSE(check.repeats(std::span(zeros).first(131)));
}

}  // namespace
}  // namespace tripoint
