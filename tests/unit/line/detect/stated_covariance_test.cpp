// What is stated of a spot's place, against the renderer's truth: mosaic, chroma, JPEG, noise.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/rendered_spots.h"

namespace tripoint {
namespace {

using bench::spot_errors;
using bench::SpotErrors;
using bench::SpotPictures;

constexpr int kPictures = 10;        // of 24 spots
constexpr double kNearlyAll = 23.0;  // chi-square of two axes: 1 in 100,000

/// What a fair count of `n` draws of 95 % does not fall below, but once in 700 times.
double fewest_of_95(std::size_t n) { return 0.95 - 3.0 * std::sqrt(0.95 * 0.05 / static_cast<double>(n)); }

void expect_covered(const SpotPictures& pictures, const std::string& what) {
  const SpotErrors errors = spot_errors(pictures, kPictures, 1);
  ASSERT_GE(errors.found.size(), 0.9 * errors.asked) << what;
  EXPECT_GE(errors.share_in_95(), fewest_of_95(errors.found.size())) << what << ", " << errors.rms_px() << " px RMS";
  for (const bench::SpotError& spot : errors.found) {
    EXPECT_LT(spot.chi2(), kNearlyAll) << what << ", off by " << spot.error_px.norm() << " px";
  }
}

constexpr ImageSize kSmall{.width_px = 320, .height_px = 240};
constexpr ImageSize kLarge{.width_px = 1280, .height_px = 720};

TEST(StatedCovarianceTest, HoldsTheTruthInYuyvAtEverySize) {
  for (const ImageSize size : {kSmall, ImageSize{640, 480}, kLarge}) {
    for (const double peak : {0.7, 1.0, 3.0}) {
      expect_covered({.size = size, .peak = peak}, std::to_string(size.width_px) + ", peak " + std::to_string(peak));
    }
  }
}

TEST(StatedCovarianceTest, HoldsTheTruthInMjpegOfEveryQuality) {
  for (const ImageSize size : {kSmall, ImageSize{640, 480}}) {
    for (const ChromaSampling sampling : {ChromaSampling::k422, ChromaSampling::k420}) {
      for (const int quality : {90, 70, 50}) {
        const std::string what = std::to_string(size.width_px) +
                                 (sampling == ChromaSampling::k422 ? ", 4:2:2, quality " : ", 4:2:0, quality ") +
                                 std::to_string(quality);
        const SpotPictures pictures{
            .size = size, .format = PixelFormat::kMjpeg, .sampling = sampling, .quality = quality, .peak = 1.5};
        expect_covered(pictures, what);
      }
    }
  }
}

TEST(StatedCovarianceTest, HoldsTheTruthWhereNoiseErrs) {
  const SensorModel noisy{.read_noise = 0.02, .full_well_electrons = 200.0};
  expect_covered({.sensor = noisy}, "YUYV");
  expect_covered({.format = PixelFormat::kMjpeg, .sensor = noisy}, "MJPEG");
}

// The tests above could not fail if the errors were small beside what any spot is stated with.
TEST(StatedCovarianceTest, OfNoiseAloneWouldNotHoldWhatChromaAndJpegDo) {
  LedDetectorSettings no_floor;
  no_floor.floor_px = no_floor.split_floor_px = 0.0;
  const SpotPictures pictures{.size = kSmall, .format = PixelFormat::kMjpeg, .quality = 50, .peak = 1.5};
  const SpotErrors errors = spot_errors(pictures, kPictures, 1, no_floor);
  EXPECT_LT(errors.share_in_95(), fewest_of_95(errors.found.size()));
}

}  // namespace
}  // namespace tripoint
