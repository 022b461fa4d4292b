#include "sim/sensor.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace tripoint {
namespace {

constexpr ImageSize kSize{.width_px = 640, .height_px = 208};

struct MeanAndVariance {
  double mean = 0.0;
  double variance = 0.0;
};

/// Counts of a plane lit evenly, in units of clip.
MeanAndVariance exposed_evenly(double level, const SensorModel& sensor) {
  const NoiseTable noise(7, 640);
  const std::vector<float> expected(640, static_cast<float>(level));
  RawPlane plane(kSize);
  double sum = 0.0;
  double squares = 0.0;
  for (int y = 0; y < kSize.height_px; ++y) {
    plane.expose_row(y, expected, noise.row(static_cast<std::uint64_t>(y)), sensor);
    for (int x = 0; x < kSize.width_px; ++x) {
      const double value = static_cast<double>(plane.row(y)[x]) / kClipCounts;
      sum += value;
      squares += value * value;
    }
  }
  const double count = 640.0 * kSize.height_px;
  return {.mean = sum / count, .variance = squares / count - (sum / count) * (sum / count)};
}

TEST(SensorTest, VarianceRisesWithTheMeanAsThePhotonTransferLine) {
  const SensorModel sensor{.read_noise = 0.004, .full_well_electrons = 5000.0};
  for (const double level : {0.0, 0.05, 0.2, 0.5, 0.9}) {
    const MeanAndVariance measured = exposed_evenly(level, sensor);
    const double rounding = 1.0 / (12.0 * kClipCounts * kClipCounts);
    const double expected = 0.004 * 0.004 + level / 5000.0 + rounding;
    // Rows draw 133,120 values out of a table of 131,712: about half as many independent ones; 5 sqrt(2 / N).
    EXPECT_NEAR(measured.variance, expected, expected * 5.0 * std::sqrt(2.0 / 66'000.0)) << level;
    EXPECT_NEAR(measured.mean, level, 5.0 * std::sqrt(expected / 66'000.0)) << level;
  }
}

TEST(SensorTest, LightBeyondClipIsClip) {
  const MeanAndVariance measured = exposed_evenly(2.0, {.read_noise = 0.01, .full_well_electrons = 5000.0});
  EXPECT_EQ(measured.mean, 1.0);
  EXPECT_EQ(measured.variance, 0.0);
}

TEST(SensorTest, WithoutNoiseCountsAreRoundedLevels) {
  const SensorModel quiet{.read_noise = 0.0, .full_well_electrons = 1e30};
  EXPECT_NEAR(exposed_evenly(0.3, quiet).mean, std::round(0.3 * 1023.0) / 1023.0, 1e-12);
}

TEST(SensorTest, RimMirrorsThePictureInTheOrderOfTheMosaic) {
  RawPlane plane({.width_px = 16, .height_px = 16});
  const std::vector<float> silence(16, 0.0F);
  for (int y = 0; y < 16; ++y) {
    std::vector<float> expected(16);
    for (std::size_t x = 0; x < 16; ++x) expected[x] = static_cast<float>(16 * y + static_cast<int>(x)) / 1023.0F;
    plane.expose_row(y, expected, silence, {.read_noise = 0.0, .full_well_electrons = 1e30});
  }
  EXPECT_EQ(plane.row(0)[-1], plane.row(0)[1]);
  EXPECT_EQ(plane.row(0)[16], plane.row(0)[14]);
  EXPECT_EQ(plane.row(-1)[3], plane.row(1)[3]);
  EXPECT_EQ(plane.row(16)[3], plane.row(14)[3]);
  EXPECT_EQ(plane.row(2)[5], 37);
}

TEST(SensorTest, MosaicIsRedGreenGreenBlue) {
  EXPECT_EQ(bayer_channel(0, 0), 0U);
  EXPECT_EQ(bayer_channel(1, 0), 1U);
  EXPECT_EQ(bayer_channel(0, 1), 1U);
  EXPECT_EQ(bayer_channel(1, 1), 2U);
}

TEST(SensorTest, NoiseOfOneKeyIsAlwaysTheSame) {
  const NoiseTable one(3, 100);
  const NoiseTable same(3, 100);
  const NoiseTable other(4, 100);
  EXPECT_TRUE(std::ranges::equal(one.row(11), same.row(11)));
  EXPECT_FALSE(std::ranges::equal(one.row(11), one.row(12)));
  EXPECT_FALSE(std::ranges::equal(one.row(11), other.row(11)));
}

}  // namespace
}  // namespace tripoint
