#include "values/latest.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

TEST(LatestTest, TheNewestValueWins) {
  Latest<int> latest(1);
  EXPECT_EQ(latest.get(), 1);
  latest.put(2);
  latest.put(3);
  EXPECT_EQ(latest.get(), 3);
  EXPECT_EQ(latest.get(), 3) << "reading takes nothing away";
}

TEST(LatestTest, ReadersSeeWholeValuesThatNeverGoBack) {
  using Image = std::array<std::uint64_t, 250>;  // as large as the register image
  Latest<Image> latest;
  std::atomic<bool> done{false};
  std::jthread writer([&] {
    Image image{};
    for (std::uint64_t n = 1; n <= 20'000; ++n) {
      image.fill(n);
      latest.put(image);
    }
    done = true;
  });
  std::uint64_t newest = 0;
  while (!done) {
    const Image image = latest.get();
    for (const std::uint64_t word : image) ASSERT_EQ(word, image[0]) << "torn";
    ASSERT_GE(image[0], newest);
    newest = image[0];
  }
}

}  // namespace
}  // namespace tripoint
