#include "line/detect/led_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "bench/painter.h"
#include "counted_allocations.h"

namespace tripoint {
namespace {

using bench::Light;
using bench::Painting;

std::vector<RawPixel> three_places(ImageSize size) {
  return {{0.21 * size.width_px + 0.37, 0.4 * size.height_px + 0.11},
          {0.52 * size.width_px - 0.21, 0.6 * size.height_px + 0.45},
          {0.80 * size.width_px + 0.08, 0.3 * size.height_px - 0.33}};
}

bench::YuyvPicture three_leds(ImageSize size, std::uint32_t seed) {
  std::mt19937 random(seed);
  Painting painting(size, 0.02);
  for (const RawPixel at : three_places(size)) painting.add(Light{.at = at});
  return painting.develop({}, random);
}

double distance_px(const RawPixel& a, const RawPixel& b) { return std::hypot(a.u_px - b.u_px, a.v_px - b.v_px); }

const ImagePoint* nearest(const Detection& detection, const RawPixel& truth) {
  const auto found = std::min_element(
      detection.points.begin(), detection.points.end(),
      [&](const ImagePoint& a, const ImagePoint& b) { return distance_px(a.at, truth) < distance_px(b.at, truth); });
  return found == detection.points.end() ? nullptr : found;
}

TEST(LedDetectorTest, FindsEachLedOnceAtEverySize) {
  for (const ImageSize size : {ImageSize{320, 240}, ImageSize{640, 480}, ImageSize{1280, 720}}) {
    LedDetector detector{LedDetectorSettings{}};
    const auto picture = three_leds(size, 5);
    const Detection detection = detector.detect(picture.view(), {});
    ASSERT_EQ(detection.points.size(), 3U) << size.width_px;
    for (const RawPixel truth : three_places(size)) {
      // Clipped core and tone curve leave 0.03 px of noise; 0.1 px is the stated floor.
      EXPECT_LT(distance_px(nearest(detection, truth)->at, truth), 0.15) << size.width_px;
    }
  }
}

TEST(LedDetectorTest, PlanesGiveTheSamePointsAsYuyv) {
  LedDetector detector{LedDetectorSettings{}};
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto picture = bench::dark_clutter({640, 480}, seed);
    const auto planes = bench::planes_of(picture, false);
    const Detection interleaved = detector.detect(picture.view(), {});
    const Detection planar = detector.detect(planes.view(), {});
    ASSERT_EQ(planar.points.size(), interleaved.points.size());
    ASSERT_GE(planar.points.size(), 2U);  // a white light lies on one LED of seed 4
    for (std::size_t i = 0; i < planar.points.size(); ++i) {
      EXPECT_EQ(planar.points[i].at.u_px, interleaved.points[i].at.u_px);
      EXPECT_EQ(planar.points[i].at.v_px, interleaved.points[i].at.v_px);
      EXPECT_EQ(planar.points[i].covariance_px2, interleaved.points[i].covariance_px2);
    }
  }
}

TEST(LedDetectorTest, HalfRowsOfChromaStillShowEveryLed) {
  const ImageSize size{640, 480};
  LedDetector detector{LedDetectorSettings{}};
  const auto planes = bench::planes_of(three_leds(size, 6), true);
  const Detection detection = detector.detect(planes.view(), {});
  ASSERT_EQ(detection.points.size(), 3U);
  for (const RawPixel truth : three_places(size)) EXPECT_LT(distance_px(nearest(detection, truth)->at, truth), 0.25);
}

TEST(LedDetectorTest, NoiseAloneShowsNothing) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    std::mt19937 random(seed);
    const double ground = 0.002 * static_cast<double>(1 + seed % 40);
    const bench::Development development{.noise = 0.001 + 0.0002 * static_cast<double>(seed % 30),
                                         .gamma = seed % 2 == 0};
    const auto picture = Painting({320, 240}, ground).develop(development, random);
    LedDetector detector{LedDetectorSettings{}};
    EXPECT_TRUE(detector.detect(picture.view(), {}).points.empty()) << "seed " << seed;
  }
}

TEST(LedDetectorTest, StatedCovarianceCoversTheErrors) {
  // 0.10 px of floor is made for real cameras: here it must cover, so chi2 per axis stays below 1.
  double chi2 = 0.0;
  int count = 0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const ImageSize size{640, 480};
    LedDetector detector{LedDetectorSettings{}};
    const auto picture = three_leds(size, seed);
    const Detection detection = detector.detect(picture.view(), {});
    for (const RawPixel truth : three_places(size)) {
      const ImagePoint* point = nearest(detection, truth);
      const Vec2 error(point->at.u_px - truth.u_px, point->at.v_px - truth.v_px);
      chi2 += 0.5 * error.dot(point->covariance_px2.inverse() * error);
      ++count;
    }
  }
  EXPECT_LT(chi2 / count, 1.0);
}

TEST(LedDetectorTest, NothingIsAllocatedOncePicturesHaveTheirSize) {
  LedDetector detector{LedDetectorSettings{}};
  const auto picture = bench::dark_clutter({640, 480}, 3);
  detector.detect(picture.view(), {});
  if (!testing::allocations_are_counted()) GTEST_SKIP() << "a sanitizer stands in for malloc: nothing can be counted";
  EXPECT_EQ(testing::allocations_in([&] { detector.detect(picture.view(), {}); }), 0);
}

TEST(LedDetectorTest, TheSamePictureGivesTheSameAnswerAfterAnother) {
  LedDetector detector{LedDetectorSettings{}};
  const auto picture = bench::dark_clutter({640, 480}, 3);
  const Detection first = detector.detect(picture.view(), {});
  detector.detect(bench::clean_scene({320, 240}, 1).view(), {});
  const Detection again = detector.detect(picture.view(), {});
  ASSERT_EQ(again.points.size(), first.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) EXPECT_EQ(again.points[i].at.u_px, first.points[i].at.u_px);
}

TEST(LedDetectorTest, LogSaysWhyEachCandidateWasDropped) {
  LedDetector detector{LedDetectorSettings{}};
  const auto picture = bench::dark_clutter({640, 480}, 3);
  const Detection detection = detector.detect(picture.view(), {});
  const auto kept = std::count_if(detector.candidates().begin(), detector.candidates().end(),
                                  [](const Candidate& c) { return c.cause == DropCause::kKept; });
  EXPECT_EQ(static_cast<std::size_t>(kept), detection.points.size());
  EXPECT_GT(detector.candidates().size(), detection.points.size());
}

TEST(LedDetectorTest, EveryCauseHasItsOwnName) {
  const std::set<std::string_view> names(kDropCauseNames.begin(), kDropCauseNames.end());
  EXPECT_EQ(names.size(), static_cast<std::size_t>(DropCause::kSprawling) + 1);
  EXPECT_EQ(names.count(""), 0U);
  EXPECT_EQ(name(DropCause::kCutByBorder), "cut_by_border");
}

TEST(LedDetectorTest, ReachedCapIsReported) {
  LedDetectorSettings settings;
  settings.max_candidates = 2;
  LedDetector detector{settings};
  const auto picture = bench::dark_clutter({640, 480}, 3);
  EXPECT_TRUE(detector.detect(picture.view(), {}).health.candidates_cut);
  LedDetector roomy{LedDetectorSettings{}};
  EXPECT_FALSE(roomy.detect(picture.view(), {}).health.candidates_cut);
}

TEST(LedDetectorTest, HealthTellsOfLightAndFocus) {
  LedDetector detector{LedDetectorSettings{}};
  const auto picture = three_leds({640, 480}, 5);
  const Detection detection = detector.detect(picture.view(), {});
  // A grey of 0.02 is coded as 16 + 0.859 * 255 * 0.02^(1/2.2) = 53.
  EXPECT_NEAR(detection.health.mean_luma, 53.0, 1.5);
  // Red alone is clipped: 16 + 0.257 * 255 = 82, and what green and blue of the LED add.
  EXPECT_GT(detection.health.peak_luma, 82.0);
  // The tone curve widens a spot of 1.8 px, up to sqrt(2.2) times.
  EXPECT_GT(detection.health.focus, 1.0 / (1.8 * 1.6));
  EXPECT_LT(detection.health.focus, 1.0 / 1.5);
}

}  // namespace
}  // namespace tripoint
