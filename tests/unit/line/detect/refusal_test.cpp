// Things that are red, bright or both, and are no LED.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "bench/painter.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using bench::Color;
using bench::Ellipse;
using bench::Light;
using bench::Painting;

constexpr ImageSize kSize{640, 480};

std::string causes(const LedDetector& detector) {
  std::string text;
  for (const Candidate& candidate : detector.candidates()) text += std::string(name(candidate.cause)) + " ";
  return text;
}

template <typename Thing>
void expect_refused(const Thing& thing, double ground, const std::string& what) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    Painting painting(kSize, ground);
    painting.add(thing);
    LedDetector detector{LedDetectorSettings{}};
    const auto picture = painting.develop({}, random);
    EXPECT_TRUE(detector.detect(picture.view(), {}).points.empty())
        << what << ", seed " << seed << ": " << causes(detector);
  }
}

TEST(RefusalTest, WhiteLampIsNotRed) {
  for (const double sigma_px : {1.0, 2.0, 6.0, 15.0}) {
    for (const double peak : {0.5, 2.0, 20.0}) {
      expect_refused(Light{.at = {300.3, 200.7}, .sigma_px = sigma_px, .peak = peak, .color = bench::kWhite}, 0.02,
                     "white lamp");
    }
  }
}

TEST(RefusalTest, WarmReflectionIsNotRed) {
  for (const Color& color : {Color{1.0, 0.75, 0.45}, Color{1.0, 0.55, 0.2}}) {
    for (const double peak : {0.3, 1.0, 5.0}) {
      expect_refused(Light{.at = {300.3, 200.7}, .peak = peak, .color = color}, 0.02, "warm reflection");
    }
  }
}

void expect_patches_refused(double light, double half_px) {
  const Color skin{0.60 * light, 0.27 * light, 0.16 * light};
  const Color orange{0.70 * light, 0.22 * light, 0.02 * light};
  expect_refused(Ellipse{{301.0, 199.0}, half_px, half_px, skin}, 0.3 * light, "skin");
  expect_refused(Ellipse{{301.0, 199.0}, half_px, half_px, orange}, 0.3 * light, "orange");
}

TEST(RefusalTest, OrangeAndSkinPatchesOfAnySizeAreRefusedAtTheRecommendedExposure) {
  for (const double half_px : {3.0, 6.0, 12.0, 20.0, 60.0}) expect_patches_refused(0.06, half_px);
}

// A brightly lit disc of a spot's size on a ground of its own luma cannot be told from a LED in one picture.
TEST(RefusalTest, OrangeAndSkinPatchesLargerThanASpotAreRefusedInAnyLight) {
  for (const double light : {0.3, 1.0}) {
    for (const double half_px : {20.0, 60.0}) expect_patches_refused(light, half_px);
  }
}

TEST(RefusalTest, LargeRedAreaIsRefusedInAnyLight) {
  for (const double light : {0.06, 0.3, 1.0}) {
    for (const double half_px : {25.0, 60.0, 150.0}) {
      const Color red{0.75 * light, 0.05 * light, 0.04 * light};
      expect_refused(Ellipse{{301.0, 199.0}, half_px, half_px, red}, 0.3 * light, "red area");
    }
  }
}

TEST(RefusalTest, RedCableIsRefused) {
  expect_refused(Ellipse{{301.0, 199.0}, 120.0, 3.0, {0.6, 0.03, 0.03}}, 0.1, "cable");
  expect_refused(Ellipse{{301.0, 199.0}, 9.0, 2.5, {0.8, 0.03, 0.03}}, 0.1, "short cable");
}

TEST(RefusalTest, SmallRedThingOnALighterGroundDoesNotEmit) {
  expect_refused(Ellipse{{301.0, 199.0}, 6.0, 6.0, {0.6, 0.03, 0.03}}, 0.5, "red dot");
}

// Its luma hardly differs from the ground's, and no middle of it can be told: the place would be stated to tens of
// pixels.
TEST(RefusalTest, SmallRedThingAsLightAsItsGroundHasNoMiddle) {
  int of_two_lights = 0;
  for (int step = 0; step <= 20; ++step) {
    const double ground = 0.070 + 0.0005 * step;
    std::mt19937 random(static_cast<std::uint32_t>(step));
    Painting painting(kSize, ground);
    painting.add(Ellipse{{301.0, 199.0}, 3.0, 3.0, Color{0.95, 0.0, 0.0}});
    LedDetector detector{LedDetectorSettings{}};
    const auto picture = painting.develop({}, random);
    for (const ImagePoint& point : detector.detect(picture.view(), {}).points) {
      EXPECT_LT(point.covariance_px2.trace(), 2.0 * 9.0) << ground << ": " << causes(detector);
    }
    of_two_lights += causes(detector).find("two_lights") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(of_two_lights, 0);
}

TEST(RefusalTest, WideHaloIsRefused) {
  expect_refused(Light{.at = {300.3, 200.7}, .sigma_px = 30.0, .peak = 3.0}, 0.02, "halo");
}

}  // namespace
}  // namespace tripoint
