#include "line/detect/light.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "bench/painter.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using bench::Color;
using bench::Development;
using bench::Light;
using bench::Painting;
using bench::YuyvPicture;

constexpr ImageSize kSize{640, 480};
constexpr RawPixel kPlace{320.3, 240.6};

YuyvPicture developed(const Painting& painting, const Development& development = {}) {
  std::mt19937 random(11);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same noise each time
  return painting.develop(development, random);
}

YuyvPicture with_light(const Light& light, double ground = 0.02, const Development& development = {}) {
  Painting painting(kSize, ground);
  painting.add(light);
  return developed(painting, development);
}

/// A ground of one colour with a patch in the lower left corner.
YuyvPicture with_white_patch(double white, double share_of_height) {
  Painting painting(kSize, 0.01);
  painting.add({.at = {0.0, 480.0},
                .half_width_px = 1e4,
                .half_height_px = 480.0 * share_of_height,
                .color = {white, white, white}});
  return developed(painting);
}

/// Everything that was looked at within 3 px of the light.
std::optional<Candidate> candidate_at_place(const Picture& picture, const LedDetectorSettings& settings = {}) {
  LedDetector detector(settings);
  detector.detect(picture, {});
  for (const Candidate& seen : detector.candidates()) {
    if (std::abs(seen.at.u_px - kPlace.u_px) < 3.0 && std::abs(seen.at.v_px - kPlace.v_px) < 3.0) return seen;
  }
  return std::nullopt;
}

/// -dU/dV of a light's colour by the coefficients of BT.601, without a tone curve.
double hue_of(const Color& color) {
  return (0.168736 * color[0] + 0.331264 * color[1] - 0.5 * color[2]) /
         (0.5 * color[0] - 0.418688 * color[1] - 0.081312 * color[2]);
}

// Chroma is coded in whole steps: the sums over some twenty pixels of the flank are good to a few hundredths.
TEST(LightTest, TheHueIsThatOfTheColour) {
  for (const Color& color : {Color{1.0, 0.0, 0.0}, Color{1.0, 0.06, 0.03}, Color{1.0, 0.2, 0.02}}) {
    const YuyvPicture picture = with_light({.at = kPlace, .peak = 0.9, .color = color}, 0.02, {.gamma = false});
    const auto seen = candidate_at_place(picture.view(), {.min_peak = 500});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(hue_of_flank(picture.view(), *seen), hue_of(color), 0.04) << color[1];
  }
}

TEST(LightTest, ARedLedHasItsHueHoweverBrightItIsAndInEveryChromaLayout) {
  for (const double peak : {0.7, 1.0, 3.0, 10.0}) {
    const YuyvPicture picture = with_light({.at = kPlace, .peak = peak});
    for (const bool halve : {false, true}) {
      const bench::PlanarPicture planes = bench::planes_of(picture, halve);
      const auto seen = candidate_at_place(planes.view());
      ASSERT_TRUE(seen) << peak;
      // After the tone curve: green and blue at 0.28 and 0.20 of red.
      EXPECT_NEAR(seen->hue, hue_of({1.0, 0.278, 0.203}), 0.06) << peak << (halve ? " 4:2:0" : " 4:2:2");
    }
  }
}

TEST(LightTest, TheColourOfTheGroundIsTakenOff) {
  Painting painting(kSize, 0.01);
  painting.add({.at = kPlace, .half_width_px = 90.0, .half_height_px = 90.0, .color = {0.01, 0.02, 0.08}});
  painting.add(Light{.at = kPlace});
  const auto seen = candidate_at_place(developed(painting).view());
  ASSERT_TRUE(seen);
  // Red is added to blue and green: their tone curve is flatter there, and less of both comes with the red.
  EXPECT_NEAR(seen->hue, hue_of({1.0, 0.2, 0.1}), 0.1);
}

TEST(LightTest, AnOrangeLightIsRefusedForItsHue) {
  const YuyvPicture picture = with_light({.at = kPlace, .peak = 1.5, .color = {1.0, 0.22, 0.03}});
  const auto seen = candidate_at_place(picture.view(), {.min_redness = 0.0});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cause, DropCause::kOtherHue);
  EXPECT_GT(seen->hue, 0.6F);
}

TEST(LightTest, ASpotAtTheCornerHasAHue) {
  const YuyvPicture picture = with_light({.at = {4.0, 5.0}});
  const Candidate candidate = [] {
    Candidate there;
    there.at = {4.0, 5.0};
    there.peak = 1200.0F;
    there.contrast = 600.0F;
    there.radius_px = 3.0F;
    there.surround_red = 128.0F;
    return there;
  }();
  EXPECT_NEAR(hue_of_flank(picture.view(), candidate), 0.42, 0.1);
}

// A green light: its flank has pixels and a colour, but none of them is redder than the surroundings.
TEST(LightTest, WhereNothingIsRedThereIsNoHue) {
  const YuyvPicture picture = with_light({.at = kPlace, .peak = 0.9, .color = {0.05, 1.0, 0.2}});
  Candidate candidate;
  candidate.at = kPlace;
  candidate.radius_px = 3.0F;
  candidate.peak = 900.0F;
  candidate.contrast = 450.0F;
  candidate.surround_red = 128.0F;
  EXPECT_EQ(hue_of_flank(picture.view(), candidate), 0.0);
  candidate.surround_red = 0.0F;  // against which the same flank is redder
  EXPECT_NE(hue_of_flank(picture.view(), candidate), 0.0);
}

TEST(LightTest, WhiteIsWhatATwentiethOfThePictureExceeds) {
  EXPECT_LT(scene_light_of(with_white_patch(1.0, 0.02).view()).white_luma, 60);
  EXPECT_EQ(scene_light_of(with_white_patch(1.0, 0.10).view()).white_luma, 235);
}

TEST(LightTest, ThePictureOfOneLumaHasThatMean) {
  const std::vector<std::uint8_t> bytes(64 * 64 * 2, 77);
  const SceneLight light =
      scene_light_of(picture_of({.format = PixelFormat::kYuyv, .size = {64, 64}, .stride_bytes = 128, .data = bytes}));
  EXPECT_DOUBLE_EQ(light.mean_luma, 77.0);
  EXPECT_EQ(light.white_luma, 77);
}

TEST(LightTest, APictureSmallerThanTheSampleIsDark) {
  const std::vector<std::uint8_t> bytes(16, 200);
  const SceneLight light =
      scene_light_of(picture_of({.format = PixelFormat::kYuyv, .size = {4, 2}, .stride_bytes = 8, .data = bytes}));
  EXPECT_EQ(light.white_luma, 0);
}

// A surface that reflects all red and nothing else, beside a white one of level w: by BT.601, range 0 to 255,
// Y = 0.299 w and V = 128 + 0.5 w; in the range of video, Y = 16 + 65.5 w and V = 128 + 112 w with w from 0 to 1.
TEST(LightTest, ARedSurfaceIsAsStrongAsBt601Says) {
  for (const double level : {0.2, 0.5, 1.0}) {
    const double full = 3.0 * 0.299 * 255.0 * level + 4.0 * (128.0 + 0.5 * 255.0 * level);
    const double video = 3.0 * (16.0 + 65.5 * level) + 4.0 * (128.0 + 112.0 * level);
    EXPECT_NEAR(strength_of_red_surface({0.0, static_cast<int>(255.0 * level)}), full, 0.025 * full);
    EXPECT_NEAR(strength_of_red_surface({0.0, static_cast<int>(16.0 + 219.0 * level)}), video, 0.02 * video);
  }
}

/// A light of this peak where a tenth of the picture is white of that level.
YuyvPicture with_light_beside_white(double peak, double white) {
  Painting painting(kSize, 0.01);
  painting.add({.at = {0.0, 480.0}, .half_width_px = 1e4, .half_height_px = 48.0, .color = {white, white, white}});
  painting.add(Light{.at = kPlace, .peak = peak});
  return developed(painting);
}

TEST(LightTest, ALightThatARedSurfaceCouldEqualIsRefused) {
  const auto seen = candidate_at_place(with_light_beside_white(0.5, 0.6).view());
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cause, DropCause::kRedSurface);
}

TEST(LightTest, WhoLooksForRedSurfacesGetsIt) {
  const auto seen = candidate_at_place(with_light_beside_white(0.5, 0.6).view(), {.min_emission = -0.1});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cause, DropCause::kKept);
}

TEST(LightTest, TheSameLightWhereWhiteIsDarkIsKept) {
  const auto seen = candidate_at_place(with_light_beside_white(0.5, 0.06).view());
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cause, DropCause::kKept);
}

TEST(LightTest, AClippedLightBesideThatWhiteIsKept) {
  const auto seen = candidate_at_place(with_light_beside_white(2.0, 0.6).view());
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cause, DropCause::kKept);
}

}  // namespace
}  // namespace tripoint
