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

constexpr ExposureOffer kOffered{microseconds{100}, microseconds{33'000}, GainRange{0, 255, 1}};
constexpr double kGainSteps = 64.0;  ///< that double the light

/// LEDs whose peak is exposure / one_at_us with gain 0 in a linear camera, seen from 0.6 to 30 times clip.
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
    return [this](const ExposureSetting& setting) -> Result<Look> {
      looked_.push_back(setting);
      Look look{.setting = setting, .peaks = {}};
      look.peaks = {seen(setting, lights_.left_one_at_us), seen(setting, lights_.right_one_at_us)};
      for (const Side side : kBothSides) look.spots[side] = look.peaks[side] ? 1 : 0;
      look.mean_luma = {lights_.mean_luma, 16.0};
      return look;
    };
  }
  [[nodiscard]] const std::vector<ExposureSetting>& looked() const { return looked_; }

 private:
  [[nodiscard]] std::optional<SeenPeaks> seen(const ExposureSetting& setting, double one_at_us) const {
    const double peak = static_cast<double>(setting.exposure.count()) * (1.0 + setting.gain / kGainSteps) / one_at_us;
    const double dimmest = peak * lights_.dimmest_share;
    if (dimmest < 0.6 || peak > 30.0) return std::nullopt;
    return SeenPeaks{std::pow(dimmest, 1.0 / lights_.gamma), std::pow(peak, 1.0 / lights_.gamma)};
  }

  Lights lights_;
  std::vector<ExposureSetting> looked_;
};

constexpr ExposureSetting kStart{microseconds{2000}, 0};

/// With the same light in both cameras.
Lights both_one_at(double one_at_us) { return {.left_one_at_us = one_at_us, .right_one_at_us = one_at_us}; }

PlaceBounds bounds(const Lights& lights, const ExposureSetting& start = kStart) {
  Stage stage(lights);
  const Result<PlaceBounds> found = bounds_at_place(stage.look_at(), kOffered, start);
  EXPECT_TRUE(found) << found.error().message;
  return found.value_or(PlaceBounds{});
}

TEST(ExposureSearchTest, TheBoundsAreWhereTheLedHasOneAndThreeTimesClip) {
  for (const double one_at_us : {120.0, 1000.0, 9'000.0}) {
    for (const int start_us : {100, 2000, 33'000}) {
      const PlaceBounds found = bounds(both_one_at(one_at_us), {microseconds{start_us}, 0});
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
  const double middle = static_cast<double>(found.look.setting.exposure.count()) / one_at_us;
  EXPECT_NEAR(std::pow(middle, 1.0 / 2.2), std::sqrt(3.0), 0.2 * std::sqrt(3.0) + 1e-3);
}

TEST(ExposureSearchTest, NothingIsAskedBeyondWhatIsOffered) {
  Stage stage(both_one_at(1e6));
  const Result<PlaceBounds> found = bounds_at_place(stage.look_at(), kOffered, kStart);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(found.error().message, HasSubstr("from 100 to 33000 us and no gain from 0 to 255 (camera left sees 0"));
  const auto exposures = std::ranges::minmax(stage.looked(), {}, &ExposureSetting::exposure);
  EXPECT_EQ(exposures.min.exposure, kOffered.shortest);
  EXPECT_EQ(exposures.max.exposure, kOffered.longest);
  const auto gains = std::ranges::minmax(stage.looked(), {}, &ExposureSetting::gain);
  EXPECT_EQ(gains.min.gain, 0);
  EXPECT_EQ(gains.max.gain, 255);
}

TEST(ExposureSearchTest, TheGainStaysWhereTheLongestExposureIsJustEnough) {
  EXPECT_EQ(bounds(both_one_at(33'000.0)).look.setting.gain, 0);
  EXPECT_GT(bounds(both_one_at(33'001.0)).look.setting.gain, 0);
}

/// 33000 us x (1 + gain / 64) / 60000 us is 1.2, a step above what is recommended, from gain 75.6 on; and with gain 76
/// the LED has clip after 60000 / (1 + 76 / 64) us. With gain 0 it is not seen at all.
TEST(ExposureSearchTest, WhereTheLongestExposureIsTooShortTheGainIsTheLowestThatIsEnough) {
  const PlaceBounds found = bounds(both_one_at(60'000.0));
  EXPECT_EQ(found.look.setting, (ExposureSetting{microseconds{33'000}, 76}));
  EXPECT_NEAR(found.shortest_us, 60'000.0 / (1.0 + 76.0 / kGainSteps), 1e-6);
  EXPECT_NEAR(found.longest_us, 3.0 * found.shortest_us, 1e-6);
}

TEST(ExposureSearchTest, AGainFromWhichTheSearchBeginsIsNotLowered) {
  const PlaceBounds found = bounds(both_one_at(1000.0), {microseconds{2000}, 64});
  EXPECT_EQ(found.look.setting.gain, 64);
  EXPECT_NEAR(found.shortest_us, 500.0, 1e-6);
}

TEST(ExposureSearchTest, ASingleGainOnOfferIsKept) {
  ExposureOffer offered = kOffered;
  offered.gains = {16, 16, 1};
  Stage stage(both_one_at(60'000.0));  // 0.69 times clip at most
  const Result<PlaceBounds> found = bounds_at_place(stage.look_at(), offered, {microseconds{2000}, 16});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_GT(found->shortest_us, 33'000.0);
  for (const ExposureSetting& setting : stage.looked()) EXPECT_EQ(setting.gain, 16);
}

/// 33000 us x (1 + 255 / 64) / 200000 us = 0.82 times clip: seen, and too dim.
TEST(ExposureSearchTest, AnLedTooDimForTheHighestGainIsMeasuredWithIt) {
  const PlaceBounds found = bounds(both_one_at(200'000.0));
  EXPECT_EQ(found.look.setting.gain, 255);
  EXPECT_NEAR(found.shortest_us, 200'000.0 / (1.0 + 255.0 / kGainSteps), 1e-6);
}

/// 16 + 219 x 0.06 = 29.14.
TEST(ExposureSearchTest, APictureAsLightAsWhiteShouldBeIsRefused) {
  Stage dark({.mean_luma = 29.1});
  EXPECT_TRUE(bounds_at_place(dark.look_at(), kOffered, kStart));
  Stage light({.mean_luma = 29.2});
  const Result<PlaceBounds> found = bounds_at_place(light.look_at(), kOffered, kStart);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kOutOfRange);
  EXPECT_THAT(found.error().message, HasSubstr("camera left"));
}

TEST(ExposureSearchTest, AnErrorOfTheCamerasEndsTheSearch) {
  int looks = 0;
  const LookAt unplugged = [&](const ExposureSetting&) -> Result<Look> {
    ++looks;
    return failure(ErrorCode::kDeviceMissing, "left: unplugged");
  };
  const Result<PlaceBounds> found = bounds_at_place(unplugged, kOffered, kStart);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kDeviceMissing);
  EXPECT_EQ(looks, 1);
}

PlaceBounds place(double shortest_us, double longest_us) {
  return {.shortest_us = shortest_us, .longest_us = longest_us, .look = {.setting = {microseconds{1}, 5}, .peaks = {}}};
}

TEST(ExposureSearchTest, TheChoiceIsAsFarFromBothBoundsAndSuitsBothEnds) {
  const ExposureSetting chosen = exposure_for(place(800, 1600), place(1000, 3000), kOffered).value();
  EXPECT_EQ(chosen, (ExposureSetting{microseconds{1265}, 5}));  // sqrt(1.6e6)
  EXPECT_EQ(exposure_for(place(1000, 1000), place(1000, 1000), kOffered)->exposure, microseconds{1000});
}

TEST(ExposureSearchTest, TheChoiceStaysWithinWhatIsOffered) {
  EXPECT_EQ(exposure_for(place(30, 120), place(30, 120), kOffered)->exposure, microseconds{100});
  EXPECT_EQ(exposure_for(place(32'000, 96'000), place(32'000, 96'000), kOffered)->exposure, microseconds{33'000});
}

std::string refusal(const PlaceBounds& near_end, const PlaceBounds& far_end) {
  const Result<ExposureSetting> chosen = exposure_for(near_end, far_end, kOffered);
  EXPECT_FALSE(chosen);
  return chosen ? "" : chosen.error().message;
}

TEST(ExposureSearchTest, AReasonIsGivenWhereNoExposureSuits) {
  EXPECT_THAT(refusal(place(300, 900), place(1000, 3000)), HasSubstr("no exposure suits both ends: from 1000 us"));
  EXPECT_THAT(refusal(place(20, 60), place(30, 90)), HasSubstr("too bright even at the shortest exposure, 100 us"));
  EXPECT_THAT(refusal(place(40'000, 120'000), place(50'000, 150'000)),
              HasSubstr("too dim even at the longest exposure, 33000 us, with gain 5"));
}

}  // namespace
}  // namespace tripoint
