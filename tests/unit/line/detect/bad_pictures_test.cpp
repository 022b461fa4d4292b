// Pictures in which nothing can be measured, or too much seems to: bounded work, no point without reason, a cause.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

#include "bench/painter.h"
#include "led_sight.h"
#include "line/detect/led_detector.h"

namespace tripoint {
namespace {

using bench::Ellipse;
using bench::Light;
using bench::Painting;
using test::chi2;
using test::kChi2Limit;
using test::refused_near;
using test::Seen;
using test::seen_in;

const auto kLogLimit = static_cast<std::size_t>(2 * LedDetectorSettings{}.max_candidates);
constexpr std::array<ImageSize, 3> kSizes{{{320, 240}, {640, 480}, {1280, 720}}};

bench::YuyvPicture even_picture(ImageSize size, std::uint8_t y, std::uint8_t u, std::uint8_t v) {
  bench::YuyvPicture picture{size, {}};
  for (int i = 0; i < size.width_px * size.height_px / 2; ++i) {
    for (const std::uint8_t byte : {y, u, y, v}) picture.bytes.push_back(byte);
  }
  return picture;
}

/// No point, bounded work, and a cause for whatever was looked at.
void expect_refused(const Seen& seen, const std::string& what) {
  EXPECT_TRUE(seen.detection.points.empty()) << what;
  EXPECT_LE(seen.log.size(), kLogLimit) << what;
  for (const Candidate& candidate : seen.log) EXPECT_NE(candidate.cause, DropCause::kKept) << what;
}

TEST(BadPicturesTest, EvenPicturesShowNothing) {
  const std::array<std::array<std::uint8_t, 3>, 7> colors{
      {{16, 128, 128}, {235, 128, 128}, {81, 90, 240}, {0, 0, 0}, {255, 255, 255}, {255, 0, 255}, {0, 255, 255}}};
  for (const ImageSize size : kSizes) {
    for (const auto& [y, u, v] : colors) {
      const auto picture = even_picture(size, y, u, v);
      expect_refused(seen_in(picture.view()), fmt::format("{} {} {}", y, u, v));
    }
  }
}

TEST(BadPicturesTest, RandomBytesShowNothing) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    auto picture = even_picture(kSizes[seed % kSizes.size()], 0, 0, 0);
    for (std::uint8_t& byte : picture.bytes) byte = static_cast<std::uint8_t>(random());
    const Seen seen = seen_in(picture.view());
    expect_refused(seen, fmt::format("seed {}", seed));
    EXPECT_FALSE(seen.log.empty()) << "seed " << seed;
  }
}

TEST(BadPicturesTest, LedThatFillsThePictureIsNoSpot) {
  for (const ImageSize size : kSizes) {
    for (const double share : {0.1, 0.3, 1.0}) {
      for (const double peak : {0.8, 3.0, 30.0}) {
        Painting painting(size, 0.02);
        painting.add(
            Light{.at = {0.5 * size.width_px, 0.5 * size.height_px}, .sigma_px = share * size.height_px, .peak = peak});
        const Seen seen = seen_in(painting);
        const std::string what = fmt::format("{} of {} px, peak {}", share, size.height_px, peak);
        expect_refused(seen, what);
        EXPECT_TRUE(share > 0.1 || !seen.log.empty()) << what;  // a wider one may have no peak that stands alone
      }
    }
  }
}

TEST(BadPicturesTest, FiveHundredRedSpotsAreMoreThanIsLookedAtAndThatIsSaid) {
  Painting painting({640, 480}, 0.02);
  for (int i = 0; i < 500; ++i) {
    painting.add(Light{.at = {20.3 + 25.0 * (i % 25), 20.4 + 23.0 * (i / 25)}, .sigma_px = 1.5, .halo = 0.0});
  }
  const Seen seen = seen_in(painting);
  EXPECT_TRUE(seen.detection.health.candidates_cut);
  EXPECT_LE(seen.detection.points.size(), kMaxImagePoints);
  EXPECT_LE(seen.log.size(), kLogLimit);
}

TEST(BadPicturesTest, LedBetweenPixelsIsOneSpotWhereItIs) {
  for (const RawPixel offset : {RawPixel{0.5, 0.0}, RawPixel{0.0, 0.5}, RawPixel{0.5, 0.5}, RawPixel{0.0, 0.0}}) {
    for (const int cell : {304, 311, 312}) {  // within a cell of the coarse map, at its end and its start
      const RawPixel at{cell + offset.u_px, 200.0 + offset.v_px};
      Painting painting({640, 480}, 0.02);
      painting.add(Light{.at = at, .sigma_px = 1.2});
      const Seen seen = seen_in(painting);
      ASSERT_EQ(seen.detection.points.size(), 1U) << at.u_px << ", " << at.v_px;
      EXPECT_NEAR(seen.detection.points[0].at.u_px, at.u_px, 0.1);
      EXPECT_NEAR(seen.detection.points[0].at.v_px, at.v_px, 0.1);
    }
  }
}

TEST(BadPicturesTest, LedBehindAFenceIsRefusedOrCoveredByItsCovariance) {
  int measured = 0;
  for (const double bar_px : {1.0, 2.0, 3.0, 5.0}) {
    for (int shift = 0; shift < 8; ++shift) {
      const RawPixel at{300.0 + shift, 200.4};
      Painting painting({640, 480}, 0.02);
      painting.add(Light{.at = at, .sigma_px = 2.5});
      for (int bar = -5; bar <= 5; ++bar) {
        painting.add(Ellipse{.at = {300.0 + 8.0 * bar, 200.0},
                             .half_width_px = 0.5 * bar_px,
                             .half_height_px = 2000.0,
                             .color = {0.01, 0.01, 0.01}});
      }
      const Seen seen = seen_in(painting);
      for (const ImagePoint& point : seen.detection.points) {
        EXPECT_LT(chi2(point, at), kChi2Limit) << bar_px << " px bars, shifted " << shift;
      }
      const bool none = seen.detection.points.empty();
      EXPECT_TRUE(!none || refused_near(seen.log, at)) << bar_px << " px bars, shifted " << shift;
      measured += none ? 0 : 1;
    }
  }
  EXPECT_GE(measured, 14);  // of 32; 19 are
}

TEST(BadPicturesTest, BloomingAcrossFortyPixelsIsRefused) {
  for (const double peak : {5.0, 50.0, 500.0}) {
    Painting painting({640, 480}, 0.02);
    painting.add(Light{.at = {300.3, 200.4}, .sigma_px = 14.0, .peak = peak});
    const Seen seen = seen_in(painting);
    EXPECT_TRUE(seen.detection.points.empty()) << "peak " << peak;
    EXPECT_FALSE(seen.log.empty()) << "peak " << peak;
  }
}

}  // namespace
}  // namespace tripoint
