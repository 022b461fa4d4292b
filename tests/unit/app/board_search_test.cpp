#include "app/board_search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using std::chrono::microseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr ExposureOffer kOffered{microseconds{100}, microseconds{33'000}, GainRange{0, 255, 1}};
constexpr double kGainSteps = 64.0;  ///< that double the light
constexpr ExposureSetting kStart{microseconds{2000}, 0};

/// A board whose white clips after some exposure with gain 0.
struct Light {
  PerSide<double> clips_at_us{20'000.0, 20'000.0};
  double black_share = 0.05;  ///< black over white
  double glare = 1.0;         ///< lightest part over the median
  double gamma = 1.0;         ///< reads as light^(1/gamma)
  double share = 0.3;         ///< of the picture
};

/// A linear camera, or one with a gamma; it sees a board while white and black are 4 % of clip apart.
class Stage {
 public:
  explicit Stage(Light light) : light_(light) {}

  LookAtBoard look_at() {
    return [this](const ExposureSetting& setting) -> Result<BoardLook> {
      looked_.push_back(setting);
      BoardLook look{.setting = setting, .board = {}};
      for (const Side side : kBothSides) {
        const BoardLevels levels = levels_with(setting, light_.clips_at_us[side]);
        const bool seen = levels.white - levels.black >= 0.04 && light_.share >= 0.06;
        look.board[side].share = levels.white - levels.black >= 0.04 ? light_.share : 0.0;
        if (seen) look.board[side].levels = levels;
      }
      return look;
    };
  }
  [[nodiscard]] const std::vector<ExposureSetting>& looked() const { return looked_; }

 private:
  [[nodiscard]] BoardLevels levels_with(const ExposureSetting& setting, double clips_at_us) const {
    const double light =
        static_cast<double>(setting.exposure.count()) * (1.0 + setting.gain / kGainSteps) / clips_at_us;
    const auto read = [&](double level) { return std::pow(std::min(1.0, level), 1.0 / light_.gamma); };
    return {.white = read(light), .black = read(light * light_.black_share), .lightest = read(light * light_.glare)};
  }

  Light light_;
  std::vector<ExposureSetting> looked_;
};

Result<BoardLook> found_in(const Light& light, const ExposureSetting& start = kStart) {
  return search_for_board(Stage(light).look_at(), kOffered, start);
}

std::string refusal_of(const Light& light) {
  const Result<BoardLook> found = found_in(light);
  EXPECT_FALSE(found);
  return found ? "" : found.error().message;
}

TEST(BoardSearchTest, WhiteEndsNearTheMiddleOfTheRangeFromWhereverTheSearchBegins) {
  const double middle = std::sqrt(0.55 * 0.80);
  for (const double clips_at_us : {300.0, 2000.0, 20'000.0, 45'000.0}) {
    for (const int start_us : {100, 2000, 33'000}) {
      const Result<BoardLook> found =
          found_in({.clips_at_us = {clips_at_us, clips_at_us}}, {microseconds{start_us}, 0});
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_EQ(found->setting.gain, 0);
      EXPECT_NEAR(static_cast<double>(found->setting.exposure.count()) / clips_at_us, middle, 0.06 * middle)
          << clips_at_us << " " << start_us;
    }
  }
}

TEST(BoardSearchTest, BothCamerasAreWithinTheRange) {
  const Result<BoardLook> found = found_in({.clips_at_us = {9000.0, 12'000.0}});
  ASSERT_TRUE(found) << found.error().message;
  const auto exposure_us = static_cast<double>(found->setting.exposure.count());
  EXPECT_LE(exposure_us / 9000.0, kBoardWhiteTo);
  EXPECT_GE(exposure_us / 12'000.0, kBoardWhiteFrom);
}

TEST(BoardSearchTest, ACameraWithAGammaOnlyTakesMoreSteps) {
  const Result<BoardLook> found = found_in({.clips_at_us = {700.0, 700.0}, .gamma = 2.2});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->board.left.levels->white, 0.663, 0.06 * 0.663 + 1e-3);
}

/// 33000 us x (1 + gain / 64) / 100000 us is 0.605, a tenth above the least, from gain 53.3 on.
TEST(BoardSearchTest, WhereTheLongestExposureIsTooShortTheGainIsTheLowestThatIsEnough) {
  const Result<BoardLook> found = found_in({.clips_at_us = {100'000.0, 100'000.0}});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->setting.gain, 54);
  EXPECT_GE(found->board.left.levels->white, kBoardWhiteFrom);
  EXPECT_LE(found->board.left.levels->white, kBoardWhiteTo);
}

/// 33000 us / 60000 us is 0.55 exactly.
TEST(BoardSearchTest, TheGainStaysWhereTheLongestExposureIsJustEnough) {
  EXPECT_EQ(found_in({.clips_at_us = {60'000.0, 60'000.0}})->setting, (ExposureSetting{microseconds{33'000}, 0}));
  EXPECT_GT(found_in({.clips_at_us = {60'100.0, 60'100.0}})->setting.gain, 0);
}

TEST(BoardSearchTest, AGainFromWhichTheSearchBeginsIsNotLowered) {
  EXPECT_EQ(found_in({}, {microseconds{2000}, 64})->setting.gain, 64);
}

TEST(BoardSearchTest, NothingIsAskedBeyondWhatIsOffered) {
  Stage stage({.share = 0.02});
  const Result<BoardLook> found = search_for_board(stage.look_at(), kOffered, kStart);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kTimeout);
  const auto exposures = std::ranges::minmax(stage.looked(), {}, &ExposureSetting::exposure);
  EXPECT_EQ(exposures.min.exposure, kOffered.shortest);
  EXPECT_EQ(exposures.max.exposure, kOffered.longest);
  EXPECT_EQ(std::ranges::max(stage.looked(), {}, &ExposureSetting::gain).gain, 255);
}

TEST(BoardSearchTest, WhereNobodyShowsABoardTheMessageSaysHowMuchIsSeenOfOne) {
  EXPECT_THAT(refusal_of({.share = 0.02}), AllOf(HasSubstr("no board of black and white is seen by both cameras"),
                                                 HasSubstr("on 2 % of camera left's picture and on 2 % of camera "
                                                           "right's picture; hold it so that it fills")));
}

TEST(BoardSearchTest, ABoardThatOnlyOneCameraSeesIsNotEnough) {
  const LookAtBoard look_at = [](const ExposureSetting& setting) -> Result<BoardLook> {
    return BoardLook{.setting = setting, .board = {{BoardLevels{0.6, 0.1, 0.6}, 0.4}, {std::nullopt, 0.0}}};
  };
  const Result<BoardLook> found = search_for_board(look_at, kOffered, kStart);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("there is something like it on 0 % of camera right's picture; hold"));
}

/// Gain 255 is light x 4.98: white then has 0.55 up to 33000 us x 4.98 / 0.55 = 299,000 us.
TEST(BoardSearchTest, TooDarkEvenWithTheHighestGainIsRefused) {
  EXPECT_TRUE(found_in({.clips_at_us = {260'000.0, 260'000.0}}));
  EXPECT_THAT(refusal_of({.clips_at_us = {400'000.0, 400'000.0}}),
              AllOf(HasSubstr("with 33000 us with gain"), HasSubstr("too dark even at the longest exposure")));
}

TEST(BoardSearchTest, TooLightEvenAtTheShortestExposureIsRefused) {
  EXPECT_THAT(refusal_of({.clips_at_us = {50.0, 50.0}}),
              AllOf(HasSubstr("with 100 us with gain 0 white has 100 % of clip in camera left"),
                    HasSubstr("too light even at the shortest exposure: take light away, or close the iris")));
}

TEST(BoardSearchTest, CamerasThatSeeTheBoardTooDifferentlyAreRefused) {
  EXPECT_TRUE(found_in({.clips_at_us = {9000.0, 13'000.0}}));  // 0.80 / 0.55 is 1.4545
  EXPECT_THAT(refusal_of({.clips_at_us = {9000.0, 13'200.0}}), HasSubstr("turn it so that both see it equally lit"));
}

TEST(BoardSearchTest, GlareIsRefused) {
  EXPECT_TRUE(found_in({.glare = 1.3}));
  EXPECT_THAT(refusal_of({.glare = 1.6}), HasSubstr("a part of the board clips; turn the board away from the lamp"));
}

TEST(BoardSearchTest, APaleBoardIsRefused) {
  EXPECT_TRUE(found_in({.black_share = 0.49}));
  EXPECT_THAT(refusal_of({.black_share = 0.51}), HasSubstr("where white should have twice as much at least"));
}

TEST(BoardSearchTest, AnErrorOfACameraEndsTheSearch) {
  for (const std::size_t good : {std::size_t{0}, std::size_t{2}, std::size_t{9}}) {
    Stage stage({.clips_at_us = {200'000.0, 200'000.0}});
    const LookAtBoard look_at = [&, seen = stage.look_at()](const ExposureSetting& setting) -> Result<BoardLook> {
      if (stage.looked().size() == good) return failure(ErrorCode::kDeviceMissing, "left: unplugged");
      return seen(setting);
    };
    const Result<BoardLook> found = search_for_board(look_at, kOffered, kStart);
    ASSERT_FALSE(found) << good;
    EXPECT_EQ(found.error().code, ErrorCode::kDeviceMissing);
  }
}

}  // namespace
}  // namespace tripoint
