// Points as a detector would give them before a grey picture: what is followed, and what is too close.
#include "modulation/light_tracks.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace tripoint {
namespace {

constexpr ImageSize kSize{320, 240};
constexpr double kSigma_px = 2.0;

ImagePoint spot_at(double u_px, double v_px) {
  ImagePoint point;
  point.at = {u_px, v_px};
  point.sigma_px = kSigma_px;
  return point;
}

class LightTracksTest : public testing::Test {
 protected:
  /// One picture, 33 ms after the one before.
  void show(const std::vector<ImagePoint>& points, LitLeds lit = LitLeds::first(1)) {
    Observation seen;
    seen.exposed = TimePoint{std::chrono::milliseconds(33 * ++pictures_)};
    for (const ImagePoint& point : points) seen.points.push_back(point);
    const Picture picture = picture_of(Frame{.side = Side::kLeft,
                                             .format = PixelFormat::kYuyv,
                                             .size = kSize,
                                             .stride_bytes = 2 * 320,
                                             .data = grey_,
                                             .sequence = 0,
                                             .exposed = {},
                                             .arrived = {},
                                             .line_time = {}});
    tracks_.follow(seen, picture, [lit](double /*row_px*/) { return lit; });
  }

  /// Red or grey, around (100, 100).
  void paint(bool red) {
    for (std::size_t v = 97; v <= 103; ++v) {
      for (std::size_t u = 96; u <= 104; u += 2) grey_[2 * (320 * v + u) + 3] = red ? 220 : 128;
    }
  }

  LightTracks tracks_{LedCode(1)};

 private:
  std::vector<std::uint8_t> grey_ = std::vector<std::uint8_t>(static_cast<std::size_t>(2 * 320 * 240), 128);
  int pictures_ = 0;
};

TEST_F(LightTracksTest, LightsWithinFourOfTheirSigmasTouch) {
  show({spot_at(100.0, 100.0), spot_at(100.0 + 4.0 * kSigma_px - 0.1, 100.0), spot_at(200.0, 100.0)});
  EXPECT_TRUE(tracks_.touched(*tracks_.of_point(0)));
  EXPECT_TRUE(tracks_.touched(*tracks_.of_point(1)));
  EXPECT_FALSE(tracks_.touched(*tracks_.of_point(2)));
  tracks_.clear();
  show({spot_at(100.0, 100.0), spot_at(100.0 + 4.0 * kSigma_px + 0.1, 100.0)});
  EXPECT_FALSE(tracks_.touched(*tracks_.of_point(0)));
}

TEST_F(LightTracksTest, ALightThatIsMissedWhereItMustBeStillTouches) {
  show({spot_at(100.0, 100.0), spot_at(107.0, 100.0)});
  show({spot_at(100.0, 100.0)});
  EXPECT_TRUE(tracks_.touched(*tracks_.of_point(0)));
}

TEST_F(LightTracksTest, ALightIsFollowedOnItsWay) {
  for (int i = 0; i < 5; ++i) {
    show({spot_at(100.0 + 10.0 * i, 100.0 + 3.0 * i), spot_at(250.0, 200.0)});
    EXPECT_EQ(tracks_.all().size(), 2U) << i;
  }
  EXPECT_EQ(tracks_.of_point(0), &tracks_.all()[0]);
}

TEST_F(LightTracksTest, OneThatJumpsIsAnother) {
  for (int i = 0; i < 3; ++i) show({spot_at(100.0, 100.0)});
  show({spot_at(140.0, 100.0)});
  EXPECT_EQ(tracks_.all().size(), 2U);
}

TEST_F(LightTracksTest, NoSpotIsNotEnoughThePlaceMustBeDark) {
  const LedCode code(1);
  for (const bool shines_on : {false, true}) {
    tracks_.clear();
    for (std::uint64_t step = 0; step < 10; ++step) {
      const LitLeds lit = code.lit_in(step);
      paint(shines_on || !lit.empty());
      show(lit.empty() ? std::vector<ImagePoint>{} : std::vector{spot_at(100.0, 100.0)}, lit);
    }
    ASSERT_EQ(tracks_.all().size(), 1U);
    EXPECT_EQ(tracks_.all()[0].blink.led().has_value(), !shines_on);
  }
}

TEST_F(LightTracksTest, OneThatIsNotSeenForAsLongAsAnLedMayBeOutIsForgotten) {
  show({spot_at(100.0, 100.0)});
  for (int i = 0; i < 3; ++i) show({});
  EXPECT_EQ(tracks_.all().size(), 1U);
  show({});
  EXPECT_TRUE(tracks_.all().empty());
}

}  // namespace
}  // namespace tripoint
