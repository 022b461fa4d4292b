#include "app/gain_search.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

/// Light enough from one gain on; remembers what was tried.
class Scene {
 public:
  explicit Scene(int enough_from) : enough_from_(enough_from) {}

  LightEnough light_enough() {
    return [this](int gain) -> Result<bool> {
      tried_.push_back(gain);
      return gain >= enough_from_;
    };
  }
  [[nodiscard]] const std::vector<int>& tried() const { return tried_; }

 private:
  int enough_from_;
  std::vector<int> tried_;
};

constexpr GainRange kOffered{0, 255, 1};

TEST(GainSearchTest, TheLowestGainThatIsEnoughIsFoundWhereverItLies) {
  for (int enough = 1; enough <= kOffered.highest; ++enough) {
    Scene scene(enough);
    EXPECT_EQ(lowest_gain(kOffered, 0, scene.light_enough()).value(), enough);
  }
}

/// A stride of 2^k is taken only when everything up to 2^k - 1 above the start was too dark.
TEST(GainSearchTest, NothingIsTriedTwiceAsFarFromTheStartAsIsNeeded) {
  constexpr int kFrom = 20;
  for (int enough = kFrom + 1; enough <= kOffered.highest; ++enough) {
    Scene scene(enough);
    EXPECT_EQ(lowest_gain(kOffered, kFrom, scene.light_enough()).value(), enough);
    EXPECT_LT(std::ranges::max(scene.tried()) - kFrom, 2 * (enough - kFrom));
    EXPECT_GT(std::ranges::min(scene.tried()), kFrom);  // known to be too dark
  }
}

/// 8 strides up to 255, and 7 halvings of the last of 128.
TEST(GainSearchTest, FifteenLooksAreEnoughForAByte) {
  for (int enough = 1; enough <= kOffered.highest + 1; ++enough) {
    Scene scene(enough);
    ASSERT_TRUE(lowest_gain(kOffered, 0, scene.light_enough()));
    EXPECT_LE(scene.tried().size(), 15U) << enough;
  }
}

TEST(GainSearchTest, OnlyGainsInTheCamerasStepsAreTried) {
  Scene scene(21);
  EXPECT_EQ(lowest_gain({4, 103, 10}, 4, scene.light_enough()).value(), 24);
  for (const int gain : scene.tried()) EXPECT_EQ(gain % 10, 4) << gain;
}

TEST(GainSearchTest, NothingIsFoundWhereNotEvenTheHighestIsEnough) {
  Scene scene(256);
  EXPECT_EQ(lowest_gain(kOffered, 0, scene.light_enough()).value(), std::nullopt);
  EXPECT_EQ(std::ranges::max(scene.tried()), 255);
  Scene between(99);  // 94 is the highest in steps of 10
  EXPECT_EQ(lowest_gain({4, 103, 10}, 4, between.light_enough()).value(), std::nullopt);
  EXPECT_EQ(std::ranges::max(between.tried()), 94);
}

TEST(GainSearchTest, FromTheHighestOnNothingIsTried) {
  Scene scene(0);
  EXPECT_EQ(lowest_gain(kOffered, 255, scene.light_enough()).value(), std::nullopt);
  EXPECT_EQ(lowest_gain({16, 16, 1}, 16, scene.light_enough()).value(), std::nullopt);
  EXPECT_TRUE(scene.tried().empty());
}

TEST(GainSearchTest, AnErrorEndsTheSearchOnTheWayUpAndOnTheWayBack) {
  for (const int unplugged_at : {3, 11}) {
    const Result<std::optional<int>> found = lowest_gain(kOffered, 0, [&](int gain) -> Result<bool> {
      if (gain == unplugged_at) return failure(ErrorCode::kDeviceMissing, "left: unplugged");
      return gain >= 10;
    });
    ASSERT_FALSE(found) << unplugged_at;
    EXPECT_EQ(found.error().code, ErrorCode::kDeviceMissing);
  }
}

}  // namespace
}  // namespace tripoint
