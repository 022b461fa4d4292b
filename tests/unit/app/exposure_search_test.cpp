#include "app/exposure_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tripoint {
namespace {

using std::chrono::microseconds;
using ::testing::HasSubstr;

constexpr ExposureRange kOffered{microseconds{100}, microseconds{33'000}};

/// LEDs whose peak is exposure / one_at_us in a linear camera, seen from 0.6 to 30 times clip.
struct Lights {
  double left_one_at_us = 1000.0;
  double right_one_at_us = 1000.0;
  double dimmest_share = 1.0;  ///< dimmest over brightest LED
  double gamma = 1.0;          ///< reads as peak^(1/gamma)
  double mean_luma = 16.0;
};

class Stage {
 public:
  explicit Stage(Lights lights) : lights_(lights) {}

  LookAt look_at() {
    return [this](microseconds exposure) -> Result<Look> {
      looked_.push_back(exposure);
      Look look{.exposure = exposure, .peaks = {}};
      look.peaks = {seen(exposure, lights_.left_one_at_us), seen(exposure, lights_.right_one_at_us)};
      for (const Side side : kBothSides) look.spots[side] = look.peaks[side] ? 1 : 0;
      look.mean_luma = {lights_.mean_luma, 16.0};
      return look;
    };
  }
  [[nodiscard]] const std::vector<microseconds>& looked() const { return looked_; }

 private:
  [[nodiscard]] std::optional<SeenPeaks> seen(microseconds exposure, double one_at_us) const {
    const double peak = static_cast<double>(exposure.count()) / one_at_us;
    const double dimmest = peak * lights_.dimmest_share;
    if (dimmest < 0.6 || peak > 30.0) return std::nullopt;
    return SeenPeaks{std::pow(dimmest, 1.0 / lights_.gamma), std::pow(peak, 1.0 / lights_.gamma)};
  }

  Lights lights_;
  std::vector<microseconds> looked_;
};

PlaceBounds bounds(const Lights& lights, microseconds start = microseconds{2000}) {
  Stage stage(lights);
  const Result<PlaceBounds> found = bounds_at_place(stage.look_at(), kOffered, start);
  EXPECT_TRUE(found) << found.error().message;
  return found.value_or(PlaceBounds{});
}

TEST(ExposureSearchTest, TheBoundsAreWhereTheLedHasOneAndThreeTimesClip) {
  for (const double one_at_us : {120.0, 1000.0, 9'000.0}) {
    for (const int start_us : {100, 2000, 33'000}) {
      const PlaceBounds found =
          bounds({.left_one_at_us = one_at_us, .right_one_at_us = one_at_us}, microseconds{start_us});
      EXPECT_NEAR(found.shortest_us, one_at_us, 1e-6 * one_at_us) << start_us;
      EXPECT_NEAR(found.longest_us, 3.0 * one_at_us, 1e-6 * one_at_us);
    }
  }
}

TEST(ExposureSearchTest, TheDimmerCameraSetsOneBoundAndTheBrighterTheOther) {
  const PlaceBounds found = bounds({.left_one_at_us = 800.0, .right_one_at_us = 1200.0, .dimmest_share = 0.8});
  EXPECT_NEAR(found.shortest_us, 1200.0 / 0.8, 1e-6);
  EXPECT_NEAR(found.longest_us, 2400.0, 1e-6);
}

TEST(ExposureSearchTest, ACameraWithAGammaOnlyTakesMoreSteps) {
  const double one_at_us = 700.0;
  const PlaceBounds found = bounds({.left_one_at_us = one_at_us, .right_one_at_us = one_at_us, .gamma = 2.2});
  const double middle = static_cast<double>(found.look.exposure.count()) / one_at_us;
  EXPECT_NEAR(std::pow(middle, 1.0 / 2.2), std::sqrt(3.0), 0.2 * std::sqrt(3.0) + 1e-3);
}

TEST(ExposureSearchTest, NothingIsAskedBeyondWhatIsOffered) {
  Stage stage({.left_one_at_us = 200'000.0, .right_one_at_us = 200'000.0});
  const Result<PlaceBounds> found = bounds_at_place(stage.look_at(), kOffered, microseconds{2000});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(found.error().message, HasSubstr("from 100 to 33000 us (camera left sees 0 red spots"));
  const auto [least, most] = std::minmax_element(stage.looked().begin(), stage.looked().end());
  EXPECT_EQ(*least, kOffered.shortest);
  EXPECT_EQ(*most, kOffered.longest);
}

/// 16 + 219 x 0.06 = 29.14.
TEST(ExposureSearchTest, APictureAsLightAsWhiteShouldBeIsRefused) {
  Stage dark({.mean_luma = 29.1});
  EXPECT_TRUE(bounds_at_place(dark.look_at(), kOffered, microseconds{2000}));
  Stage light({.mean_luma = 29.2});
  const Result<PlaceBounds> found = bounds_at_place(light.look_at(), kOffered, microseconds{2000});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kOutOfRange);
  EXPECT_THAT(found.error().message, HasSubstr("camera left"));
}

TEST(ExposureSearchTest, AnErrorOfTheCamerasEndsTheSearch) {
  int looks = 0;
  const LookAt unplugged = [&](microseconds) -> Result<Look> {
    ++looks;
    return failure(ErrorCode::kDeviceMissing, "left: unplugged");
  };
  const Result<PlaceBounds> found = bounds_at_place(unplugged, kOffered, microseconds{2000});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kDeviceMissing);
  EXPECT_EQ(looks, 1);
}

PlaceBounds place(double shortest_us, double longest_us) {
  return {.shortest_us = shortest_us, .longest_us = longest_us, .look = {}};
}

TEST(ExposureSearchTest, TheChoiceIsAsFarFromBothBoundsAndSuitsBothEnds) {
  EXPECT_EQ(exposure_for(place(800, 1600), place(1000, 3000), kOffered).value(), microseconds{1265});  // sqrt(1.6e6)
  EXPECT_EQ(exposure_for(place(1000, 1000), place(1000, 1000), kOffered).value(), microseconds{1000});
}

TEST(ExposureSearchTest, TheChoiceStaysWithinWhatIsOffered) {
  EXPECT_EQ(exposure_for(place(30, 120), place(30, 120), kOffered).value(), microseconds{100});
  EXPECT_EQ(exposure_for(place(32'000, 96'000), place(32'000, 96'000), kOffered).value(), microseconds{33'000});
}

std::string refusal(const PlaceBounds& near_end, const PlaceBounds& far_end) {
  const Result<microseconds> chosen = exposure_for(near_end, far_end, kOffered);
  EXPECT_FALSE(chosen);
  return chosen ? "" : chosen.error().message;
}

TEST(ExposureSearchTest, AReasonIsGivenWhereNoExposureSuits) {
  EXPECT_THAT(refusal(place(300, 900), place(1000, 3000)), HasSubstr("no exposure suits both ends: from 1000 us"));
  EXPECT_THAT(refusal(place(20, 60), place(30, 90)), HasSubstr("too bright even at the shortest exposure, 100 us"));
  EXPECT_THAT(refusal(place(40'000, 120'000), place(50'000, 150'000)),
              HasSubstr("too dim even at the longest exposure, 33000 us"));
}

}  // namespace
}  // namespace tripoint
