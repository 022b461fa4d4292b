// A picture of which only bands of rows are known: its spots are those of the whole picture, or none.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bench/painter.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using bench::Light;
using bench::Painting;
using bench::PlanarPicture;

constexpr ImageSize kSize{640, 480};

PlanarPicture planes_with(const std::vector<Light>& lights, std::uint32_t seed) {
  std::mt19937 random(seed);
  Painting painting(kSize, 0.02);
  for (const Light& light : lights) painting.add(light);
  return bench::planes_of(painting.develop({}, random), false);
}

Light led_at(double u_px, double v_px, double sigma_px = 1.8) {
  return Light{.at = {u_px, v_px}, .sigma_px = sigma_px};
}

void copy_rows(const PlanarPicture& from, PlanarPicture& to, const RowBand& band) {
  const auto copy = [&](const std::vector<std::uint8_t>& source, std::vector<std::uint8_t>& target) {
    const auto stride = static_cast<std::ptrdiff_t>(source.size()) / kSize.height_px;
    std::copy(source.begin() + band.top_px * stride, source.begin() + band.bottom_px * stride,
              target.begin() + band.top_px * stride);
  };
  copy(from.luma, to.luma);
  copy(from.u, to.u);
  copy(from.v, to.v);
}

/// As a decoder leaves it: the bands show the new picture, all other rows hold anything.
PlanarPicture only_bands(const PlanarPicture& whole, const RowBands& bands) {
  PlanarPicture part = whole;
  for (auto* plane : {&part.luma, &part.u, &part.v}) std::fill(plane->begin(), plane->end(), std::uint8_t{255});
  for (const RowBand& band : bands) copy_rows(whole, part, band);
  return part;
}

RowBands around(const FixedVector<ImagePoint, kMaxImagePoints>& points, int more_px) {
  RowBands bands;
  for (const ImagePoint& point : points) {
    const int middle = static_cast<int>(point.at.v_px);
    const int reach = point.reach_px + more_px;
    bands.push_back({(middle - reach) & ~7, (middle + reach + 8) & ~7});
  }
  return bands;
}

Detection detect_bands(LedDetector& detector, const PlanarPicture& whole, const RowBands& bands) {
  const PlanarPicture part = only_bands(whole, bands);
  Picture picture = part.view();
  picture.bands = bands;
  return detector.detect(picture, {});
}

bool same(const ImagePoint& a, const ImagePoint& b) {
  return a.at.u_px == b.at.u_px && a.at.v_px == b.at.v_px && a.covariance_px2 == b.covariance_px2 &&
         a.amplitude == b.amplitude && a.sigma_px == b.sigma_px && a.peak == b.peak && a.weak == b.weak &&
         a.saturated == b.saturated && a.reach_px == b.reach_px;
}

bool among(const ImagePoint& point, const Detection& detection) {
  return std::any_of(detection.points.begin(), detection.points.end(),
                     [&](const ImagePoint& other) { return same(point, other); });
}

/// LEDs that move a few pixels from picture to picture, of sizes from small to blurred.
std::vector<Light> moving_leds(int step) {
  const double by = 3.0 * step;
  return {led_at(120.3 + by, 90.7 + by, 1.1), led_at(330.6 - by, 250.2 + by, 2.2), led_at(500.1 + by, 402.4 - by, 5.0)};
}

TEST(BandsTest, SpotsAreThoseOfTheWholePictureToTheBit) {
  LedDetector whole{LedDetectorSettings{}};
  LedDetector tracking{LedDetectorSettings{}};
  RowBands bands;
  for (int step = 0; step < 12; ++step) {
    const PlanarPicture picture = planes_with(moving_leds(step), 100 + static_cast<std::uint32_t>(step));
    const Detection truth = whole.detect(picture.view(), {});
    ASSERT_EQ(truth.points.size(), 3U) << step;
    const Detection found =
        step % 5 == 0 ? tracking.detect(picture.view(), {}) : detect_bands(tracking, picture, bands);
    ASSERT_EQ(found.points.size(), 3U) << step;
    for (const ImagePoint& point : found.points) EXPECT_TRUE(among(point, truth)) << step;
    EXPECT_EQ(found.health.focus, truth.health.focus);
    EXPECT_EQ(found.health.peak_luma, truth.health.peak_luma);
    EXPECT_NEAR(found.health.mean_luma, truth.health.mean_luma, 0.5);  // of the last whole picture of a scene at rest
    bands = around(found.points, 8);
  }
}

TEST(BandsTest, WhateverTheBandsASpotIsAsInTheWholePictureOrMissing) {
  LedDetector whole{LedDetectorSettings{}};
  LedDetector part{LedDetectorSettings{}};
  const auto picture = bench::planes_of(bench::dark_clutter(kSize, 3), false);
  const Detection truth = whole.detect(picture.view(), {});
  std::size_t kept = 0;
  std::size_t beyond = 0;
  for (int top = 0; top + 8 <= kSize.height_px; top += 8) {
    for (const int height : {8, 40, 96}) {
      part.detect(picture.view(), {});
      RowBands bands;
      bands.push_back({top, std::min(top + height, kSize.height_px)});
      const Detection found = detect_bands(part, picture, bands);
      for (const ImagePoint& point : found.points) EXPECT_TRUE(among(point, truth)) << top << "+" << height;
      kept += found.points.size();
      beyond += static_cast<std::size_t>(
          std::count_if(part.candidates().begin(), part.candidates().end(),
                        [](const Candidate& candidate) { return candidate.cause == DropCause::kBeyondBand; }));
    }
  }
  EXPECT_GT(kept, 10U);
  EXPECT_GT(beyond, 10U);
}

TEST(BandsTest, NothingIsFoundBetweenTheBands) {
  LedDetector detector{LedDetectorSettings{}};
  const PlanarPicture picture = planes_with({led_at(100.0, 100.0), led_at(400.0, 300.0)}, 7);
  ASSERT_EQ(detector.detect(picture.view(), {}).points.size(), 2U);
  RowBands bands;
  bands.push_back({56, 144});
  const Detection found = detect_bands(detector, picture, bands);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_NEAR(found.points[0].at.v_px, 100.0, 0.2);
}

TEST(BandsTest, ABandAtTheEdgeOfThePictureEndsWhereThePictureDoes) {
  LedDetector detector{LedDetectorSettings{}};
  const PlanarPicture picture = planes_with({led_at(100.0, 11.0), led_at(400.0, 468.5)}, 8);
  const Detection truth = detector.detect(picture.view(), {});
  ASSERT_EQ(truth.points.size(), 2U);
  RowBands bands;
  bands.push_back({0, 48});
  bands.push_back({432, 480});
  EXPECT_EQ(detect_bands(detector, picture, bands).points.size(), 2U);
}

}  // namespace
}  // namespace tripoint
