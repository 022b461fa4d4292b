// LEDs that are cut, hidden, merged, clipped or weak: measured within what is stated, or refused with a cause.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "bench/painter.h"
#include "led_sight.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using bench::Ellipse;
using bench::kWhite;
using bench::Light;
using bench::Painting;
using test::chi2;
using test::kChi2Limit;
using test::refused_near;
using test::Seen;
using test::seen_in;

constexpr ImageSize kSize{640, 480};

bool dropped_for(const CandidateLog& log, DropCause cause) {
  return std::any_of(log.begin(), log.end(), [&](const Candidate& c) { return c.cause == cause; });
}

TEST(DifficultSpotsTest, LedCutByAnyBorderIsRefusedWithThatCause) {
  for (const RawPixel at : {RawPixel{0.6, 200.0}, RawPixel{638.7, 200.0}, RawPixel{300.0, 0.4}, RawPixel{300.0, 478.9},
                            RawPixel{0.3, 0.3}}) {
    Painting painting(kSize, 0.02);
    painting.add(Light{.at = at});
    const Seen seen = seen_in(painting);
    EXPECT_TRUE(seen.detection.points.empty()) << at.u_px << ", " << at.v_px;
    EXPECT_TRUE(dropped_for(seen.log, DropCause::kCutByBorder)) << at.u_px << ", " << at.v_px;
  }
}

TEST(DifficultSpotsTest, LedNearTheBorderIsMeasuredWithinItsCovariance) {
  for (const double distance_px : {7.0, 8.5, 10.0, 14.0}) {
    const RawPixel at{distance_px, 200.3};
    Painting painting(kSize, 0.02);
    painting.add(Light{.at = at});
    const Seen seen = seen_in(painting);
    ASSERT_EQ(seen.detection.points.size(), 1U) << distance_px;
    EXPECT_LT(chi2(seen.detection.points[0], at), kChi2Limit) << distance_px;
  }
}

TEST(DifficultSpotsTest, TwoLedsApartAreBothFound) {
  for (const double apart_px : {14.0, 18.0, 24.0, 30.0}) {
    Painting painting(kSize, 0.02);
    const RawPixel first{300.2, 200.4};
    const RawPixel second{300.2 + 0.8 * apart_px, 200.4 + 0.6 * apart_px};
    painting.add(Light{.at = first, .sigma_px = 1.5});
    painting.add(Light{.at = second, .sigma_px = 1.5});
    const Seen seen = seen_in(painting);
    ASSERT_EQ(seen.detection.points.size(), 2U) << apart_px;
    for (const ImagePoint& point : seen.detection.points) {
      EXPECT_LT(std::min(chi2(point, first), chi2(point, second)), kChi2Limit) << apart_px;
    }
  }
}

TEST(DifficultSpotsTest, MergedLedsAreRefusedOrEachPointCoversOneOfThemWithItsCovariance) {
  int measured = 0;
  for (double apart_px = 3.0; apart_px < 14.0; apart_px += 0.5) {
    Painting painting(kSize, 0.02);
    const RawPixel first{300.2, 200.4};
    const RawPixel second{300.2 + 0.8 * apart_px, 200.4 + 0.6 * apart_px};
    painting.add(Light{.at = first, .sigma_px = 1.5});
    painting.add(Light{.at = second, .sigma_px = 1.5});
    const Seen seen = seen_in(painting);
    for (const ImagePoint& point : seen.detection.points) {
      EXPECT_LT(std::min(chi2(point, first), chi2(point, second)), kChi2Limit) << apart_px;
    }
    const bool none = seen.detection.points.empty();
    EXPECT_TRUE(!none || refused_near(seen.log, first)) << apart_px;
    measured += none ? 0 : 1;
  }
  EXPECT_GE(measured, 15);  // of 22; 20 are
}

TEST(DifficultSpotsTest, MergedLedsMeasuredAsOneAreStatedSoWideThatEitherMayBeIt) {
  // 1.5 px wide: from 3.0 px on they can be told from one LED that is seen from the side.
  int measured = 0;
  int within_95 = 0;
  for (int i = 0; i < 30; ++i) {
    const double apart_px = 3.0 + 0.05 * i;
    const double angle_rad = 1.7 * i;
    Painting painting(kSize, 0.02);
    const RawPixel first{300.2 + 0.13 * i, 200.4 + 0.07 * i};
    const RawPixel second{first.u_px + apart_px * std::cos(angle_rad), first.v_px + apart_px * std::sin(angle_rad)};
    painting.add(Light{.at = first, .sigma_px = 1.5});
    painting.add(Light{.at = second, .sigma_px = 1.5, .peak = i % 2 == 0 ? 1.5 : 0.9});
    const Seen seen = seen_in(painting, static_cast<std::uint32_t>(i));
    if (seen.detection.points.size() != 1) continue;
    const ImagePoint& point = seen.detection.points[0];
    measured += 2;
    for (const RawPixel& led : {first, second}) within_95 += chi2(point, led) < 5.991 ? 1 : 0;
  }
  EXPECT_GT(measured, 40);  // of 60
  EXPECT_GE(within_95, 0.95 * measured);
}

// A white highlight draws the centre of the luma away; the LED's red stays where it is.
TEST(DifficultSpotsTest, LedBesideAWhiteHighlightIsRefusedOrCoveredByItsCovariance) {
  const RawPixel at{300.2, 200.4};
  int measured = 0;
  for (const double apart_px : {2.0, 3.0}) {
    for (const auto& [peak, white] : {std::pair{1.0, 0.2}, {1.5, 0.4}}) {
      for (int eighth = 0; eighth < 8; ++eighth) {
        const double angle_rad = eighth * std::numbers::pi / 4.0;
        Painting painting(kSize, 0.02);
        painting.add(Light{.at = at, .sigma_px = 1.3, .peak = peak});
        painting.add(Light{.at = {at.u_px + apart_px * std::cos(angle_rad), at.v_px + apart_px * std::sin(angle_rad)},
                           .sigma_px = 1.0,
                           .peak = white,
                           .color = kWhite});
        const Seen seen = seen_in(painting);
        for (const ImagePoint& point : seen.detection.points) {
          EXPECT_LT(chi2(point, at), kChi2Limit) << apart_px << " px, " << white << ", eighth " << eighth;
          EXPECT_LT(point.covariance_px2.trace(), 2.0 * 4.0) << "2 px per axis say nothing any more";
          ++measured;
        }
      }
    }
  }
  EXPECT_GE(measured, 4);
}

TEST(DifficultSpotsTest, LedWhoseCentreShowsIsRefusedOrCoveredByItsCovariance) {
  // Once the centre itself is hidden, no single picture can say where it was.
  int measured = 0;
  for (double edge_px = 0.0; edge_px <= 5.0; edge_px += 0.5) {
    Painting painting(kSize, 0.02);
    const RawPixel at{300.2, 200.4};
    painting.add(Light{.at = at});
    painting.add(Ellipse{{at.u_px + edge_px + 40.0, at.v_px}, 40.0, 40.0, {0.02, 0.02, 0.02}});
    const Seen seen = seen_in(painting);
    for (const ImagePoint& point : seen.detection.points) {
      EXPECT_LT(chi2(point, at), kChi2Limit) << "edge at " << edge_px << " px";
    }
    const bool none = seen.detection.points.empty();
    EXPECT_TRUE(!none || refused_near(seen.log, at)) << "edge at " << edge_px << " px";
    measured += none ? 0 : 1;
  }
  EXPECT_GE(measured, 8);  // of 11; all are
}

TEST(DifficultSpotsTest, LedWhoseThreeColoursClipIsMarkedOneWhoseRedClipsIsNotAndBothAreMeasured) {
  const double all_clip = 1.0 / *std::min_element(bench::kRedLed.begin(), bench::kRedLed.end());  // 33
  for (const double peak : {1.5, 3.0, 10.0, 20.0, 100.0}) {
    Painting painting(kSize, 0.02);
    const RawPixel at{300.2, 200.4};
    painting.add(Light{.at = at, .peak = peak});
    const Seen seen = seen_in(painting);
    ASSERT_EQ(seen.detection.points.size(), 1U) << peak;
    EXPECT_EQ(seen.detection.points[0].saturated, peak > all_clip) << peak;
    EXPECT_LT(chi2(seen.detection.points[0], at), kChi2Limit) << peak;
  }
}

TEST(DifficultSpotsTest, UnclippedLedIsNotMarked) {
  Painting painting(kSize, 0.01);
  painting.add(Light{.at = {300.2, 200.4}, .peak = 0.6});
  const Seen seen = seen_in(painting);
  ASSERT_EQ(seen.detection.points.size(), 1U);
  EXPECT_FALSE(seen.detection.points[0].saturated);
  EXPECT_FALSE(seen.detection.points[0].weak);
}

TEST(DifficultSpotsTest, WeakLedIsMarkedMeasuredOnStrengthAndLessCertain) {
  std::mt19937 random(1);
  const RawPixel at{300.2, 200.4};
  Painting painting(kSize, 0.02);
  painting.add(Light{.at = at, .peak = 0.6});
  LedDetectorSettings settings;
  settings.weak_amplitude = 200.0;  // more than any red LED can have in Y
  LedDetector detector{settings};
  const auto picture = painting.develop({}, random);
  const Detection detection = detector.detect(picture.view(), {});
  ASSERT_EQ(detection.points.size(), 1U);
  EXPECT_TRUE(detection.points[0].weak);
  EXPECT_GE(detection.points[0].covariance_px2(0, 0), settings.split_floor_px * settings.split_floor_px);
  EXPECT_LT(chi2(detection.points[0], at), kChi2Limit);
}

TEST(DifficultSpotsTest, SpotSmallerThanALensMakesIsRefusedForItsSize) {
  // With the tone curve 0.6 px look like 0.78: as a red hot pixel behind the demosaicing, sqrt(1/2) px and more.
  Painting painting(kSize, 0.02);
  painting.add(Light{.at = {300.0, 200.0}, .sigma_px = 0.6, .peak = 0.9, .halo = 0.0});
  const Seen seen = seen_in(painting);
  EXPECT_TRUE(seen.detection.points.empty());
  EXPECT_TRUE(std::any_of(seen.log.begin(), seen.log.end(),
                          [](const Candidate& candidate) { return candidate.cause == DropCause::kWrongSize; }));
}

TEST(DifficultSpotsTest, SharpLedIsStatedLessCertain) {
  // A mosaic displaces a spot that falls between its red pixels; this picture has no mosaic and cannot show it.
  const auto deviation_px = [](double sigma_px) {
    Painting painting({320, 240}, 0.02);
    painting.add(Light{.at = {150.2, 100.4}, .sigma_px = sigma_px, .peak = 0.9});
    const Seen seen = seen_in(painting);
    return seen.detection.points.size() == 1 ? std::sqrt(seen.detection.points[0].covariance_px2(0, 0)) : 0.0;
  };
  EXPECT_GT(deviation_px(0.7), 0.15);
  EXPECT_LT(deviation_px(1.5), 0.12);
}

TEST(DifficultSpotsTest, LedOnPatternedGroundIsCoveredByItsCovariance) {
  double sum = 0.0;
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> level(0.05, 0.15);
    std::uniform_real_distribution<double> offset(-5.0, 5.0);
    Painting painting(kSize, 0.05);
    for (int i = 0; i < 81; ++i) {
      const double white = level(random);
      painting.add(Ellipse{.at = {260.0 + 10.0 * (i % 9), 160.0 + 10.0 * (i / 9)},
                           .half_width_px = 5.0,
                           .half_height_px = 5.0,
                           .color = {white, white, white}});
    }
    const RawPixel at{300.0 + offset(random), 200.0 + offset(random)};
    painting.add(Light{.at = at});
    const Seen seen = seen_in(painting, seed);
    for (const ImagePoint& point : seen.detection.points) {
      if (std::hypot(point.at.u_px - at.u_px, point.at.v_px - at.v_px) > 3.0) continue;
      ++found;
      sum += 0.5 * chi2(point, at);
    }
  }
  EXPECT_GT(found, 40);
  // 1 for true normal errors; its standard deviation over 40 spots is 0.16, and 4 of them.
  EXPECT_LT(sum / found, 1.6);
}

TEST(DifficultSpotsTest, SmallLedIsFoundWhereverItLiesBetweenTheRowsOfSharedChroma) {
  for (int phase = 0; phase < 8; ++phase) {
    const RawPixel at{300.2, 200.0 + phase / 4.0};
    Painting painting(kSize, 0.02);
    painting.add(Light{.at = at, .sigma_px = 1.0, .peak = 0.45});
    std::mt19937 random(1);
    const auto picture = painting.develop({.gamma = false}, random);
    for (const bool halved : {false, true}) {
      const auto planes = bench::planes_of(picture, halved);
      const Seen seen = seen_in(planes.view());
      ASSERT_EQ(seen.detection.points.size(), 1U) << at.v_px << (halved ? ", 4:2:0" : ", 4:2:2");
      EXPECT_LT(chi2(seen.detection.points[0], at), kChi2Limit) << at.v_px;
    }
  }
}

TEST(DifficultSpotsTest, WideSpotNeedsTheSameLightWhereverRowsShareChroma) {
  // Its limit is a peak of 0.33 in 4:2:2. Two rows differ by less than 5 % of a spot of 3 px.
  for (const double peak : {0.24, 0.27, 0.30, 0.36, 0.39}) {
    Painting painting(kSize, 0.02);
    painting.add(Light{.at = {300.2, 201.0}, .sigma_px = 3.0, .peak = peak});
    std::mt19937 random(1);
    const auto picture = painting.develop({.gamma = false}, random);
    for (const bool halved : {false, true}) {
      const auto planes = bench::planes_of(picture, halved);
      const std::size_t points = seen_in(planes.view()).detection.points.size();
      EXPECT_EQ(points, peak > 0.33 ? 1U : 0U) << peak << (halved ? ", 4:2:0" : ", 4:2:2");
    }
  }
}

TEST(DifficultSpotsTest, TooDimALedIsRefusedAsDim) {
  Painting painting(kSize, 0.005);
  painting.add(Light{.at = {300.2, 200.4}, .peak = 0.07});
  const Seen seen = seen_in(painting);
  EXPECT_TRUE(seen.detection.points.empty());
  EXPECT_TRUE(dropped_for(seen.log, DropCause::kDim));
}

}  // namespace
}  // namespace tripoint
