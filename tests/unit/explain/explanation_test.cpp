// The whole image of pictures that are painted here, looked at by the real detector.
#include "explain/explanation.h"

#include <gtest/gtest.h>

#include <random>

#include "bench/painter.h"
#include "explain/close_up.h"
#include "explain/look.h"

namespace tripoint {
namespace {

using bench::Light;
using bench::Painting;

RgbImage explained(const Picture& picture) {
  const LedDetectorSettings settings;
  LedDetector detector(settings);
  const Detection detection = detector.detect(picture, {});
  return explanation_of({picture, detector.candidates(), detection, settings}, "painted");
}

RgbImage explained(const Painting& painting) {
  std::mt19937 random(3);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same noise each time
  return explained(painting.develop({}, random).view());
}

long pixels_of(const RgbImage& image, Colour colour) {
  long count = 0;
  for (int y = 0; y < image.size.height_px; ++y) {
    for (int x = 0; x < image.size.width_px; ++x) count += image.at(x, y) == colour ? 1 : 0;
  }
  return count;
}

Painting with_lights(ImageSize size, int lights) {
  Painting painting(size, 0.01);
  std::mt19937 random(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp)
  std::uniform_real_distribution<double> u(0.0, size.width_px);
  std::uniform_real_distribution<double> v(0.0, size.height_px);
  for (int i = 0; i < lights; ++i) painting.add(Light{.at = {u(random), v(random)}});
  return painting;
}

TEST(ExplanationTest, AKeptSpotAddsACloseUp) {
  Painting painting({640, 480}, 0.01);
  const RgbImage without = explained(painting);
  painting.add(Light{.at = {200.0, 100.0}});
  const RgbImage with = explained(painting);
  EXPECT_GT(with.size.height_px, without.size.height_px + kCloseUpSize.height_px);
  EXPECT_GT(pixels_of(with, kKeptColour), pixels_of(without, kKeptColour) + kCloseUpSize.width_px);
}

TEST(ExplanationTest, ACandidateAtTheBorderIsShownWithWhatLiesOutside) {
  Painting painting({640, 480}, 0.01);
  painting.add(Light{.at = {1.0, 240.0}, .sigma_px = 3.0});
  const RgbImage image = explained(painting);
  EXPECT_GT(pixels_of(image, kOutside), 50L * kCloseUpSize.width_px);
}

TEST(ExplanationTest, FiveHundredSpotsGiveAnImageOfTheUsualSize) {
  const RgbImage image = explained(with_lights({640, 480}, 500));
  EXPECT_EQ(image.size.width_px, 1280 + 2 * kMargin_px);
  EXPECT_LT(image.size.height_px, 960 + 1700);  // 24 close-ups in rows of 6, and the heading
}

TEST(ExplanationTest, AHugePictureIsShownReduced) {
  Painting painting({3840, 2160}, 0.01);
  painting.add(Light{.at = {3000.0, 2000.0}, .sigma_px = 4.0});
  const RgbImage image = explained(painting);
  EXPECT_EQ(image.size.width_px, 1920 + 2 * kMargin_px);
  EXPECT_GT(pixels_of(image, kKeptColour), kCloseUpSize.width_px);
}

TEST(ExplanationTest, AGreyPictureIsShownWithoutMarks) {
  const std::vector<std::uint8_t> levels(64 * 48, 120);
  const Picture picture =
      picture_of({.format = PixelFormat::kGrey, .size = {64, 48}, .stride_bytes = 64, .data = levels});
  const LedDetectorSettings settings;
  const RgbImage image = explanation_of({picture, CandidateLog{}, Detection{}, settings}, "grey");
  EXPECT_GE(pixels_of(image, {120, 120, 120}), 64 * 48 * 64);  // shown eight times as large
}

TEST(ExplanationTest, PicturesOfOnePixelInOneDirectionAreNoTrouble) {
  for (const ImageSize size : {ImageSize{2, 1}, ImageSize{2, 4096}, ImageSize{4096, 1}}) {
    EXPECT_GT(explained(Painting(size, 0.01)).size.height_px, 0);
  }
}

}  // namespace
}  // namespace tripoint
