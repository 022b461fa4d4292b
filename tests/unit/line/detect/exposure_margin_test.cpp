#include "line/detect/exposure_margin.h"

#include <gtest/gtest.h>

#include <vector>

#include "line/detect/led_detector.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace tripoint {
namespace {

/// Luma of BT.601 by hand: 16 + 219 x (0.299 + 0.587 x 0.06 + 0.114 x 0.03) where red just clips, and so on.
TEST(ExposureMarginTest, APeakIsTheLumaOfARedLedWhoseChannelsClipOneAfterTheOther) {
  EXPECT_NEAR(luma_from_led_peak(1.0), 89.943, 1e-3);
  EXPECT_NEAR(luma_from_led_peak(0.5), 16.0 + 0.5 * 73.943, 1e-3);
  EXPECT_NEAR(luma_from_led_peak(3.0), 81.481 + 3.0 * 8.4621, 1e-3);
  EXPECT_NEAR(luma_from_led_peak(20.0), 81.481 + 128.553 + 20.0 * 0.74898, 1e-3);
  EXPECT_NEAR(luma_from_led_peak(100.0), 235.0, 1e-9);
}

TEST(ExposureMarginTest, TheLumaTellsThePeakUntilAllChannelsClip) {
  for (const double peak : {0.0, 0.3, 1.0, 1.7, 16.6, 16.7, 33.3}) {
    EXPECT_NEAR(led_peak_from_luma(luma_from_led_peak(peak)), peak, 1e-9);
  }
  EXPECT_EQ(led_peak_from_luma(0.0), 0.0);
  EXPECT_NEAR(led_peak_from_luma(255.0), 100.0 / 3.0, 1e-9);
}

TEST(ExposureMarginTest, OneIsAtTheLimitOfEitherEnd) {
  const ExposureMargin ends = exposure_margin(luma_from_led_peak(0.5), luma_from_led_peak(30.0));
  EXPECT_NEAR(ends.above_dim, 1.0, 1e-9);
  EXPECT_NEAR(ends.below_clipping, 1.0, 1e-9);
  const ExposureMargin clipped = exposure_margin(255.0, 255.0);
  EXPECT_LT(clipped.below_clipping, 1.0);
  const ExposureMargin dark = exposure_margin(0.0, 0.0);
  EXPECT_EQ(dark.above_dim, 0.0);
  EXPECT_EQ(dark.below_clipping, 3000.0);
}

/// Two LEDs 400 mm away, where their peak is what the scene says.
ImageHealth health_of(double dim_peak, double bright_peak) {
  SimulationSettings settings;
  settings.scene = led_scene({{-20.3, 4.1, 0.0}, {17.7, -6.2, 0.0}});
  settings.scene.lights[0].peak = dim_peak;
  settings.scene.lights[1].peak = bright_peak;
  settings.trajectory = {.period = std::chrono::seconds{1}, .reference_from_target = [](double) {
                           Isometry3 pose = Isometry3::Identity();
                           pose.translation() = Vec3(0.0, 0.0, kPeakDistance_mm);
                           return pose;
                         }};
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  const RenderedFrame frame = render(world, Side::kLeft, Duration{0}, 0);
  LedDetector detector{LedDetectorSettings{}};
  const Detection detection = detector.detect(picture_of(frame_of(frame)), {});
  EXPECT_EQ(detection.points.size(), 2U) << dim_peak << ", " << bright_peak;
  return detection.health;
}

/// A pixel takes the mean over its area and the mosaic has to be filled in: up to 15 % of the light of a spot of
/// sigma 2 px. The scene's grey wall adds 0.025 of clip in all channels, 5 luma: 0.07 of clip while red does not clip,
/// 0.65 afterwards, where luma rises by 8.5 for each clip. At the knee itself the noise decides.
double tolerance(double peak) { return 0.15 * peak + (peak <= 1.0 ? 0.07 : 0.65); }

TEST(ExposureMarginTest, RenderedLedsOfKnownPeakReadAsThatPeak) {
  for (const auto& [dim, bright] :
       std::vector<std::pair<double, double>>{{0.7, 0.85}, {1.5, 3.0}, {2.0, 8.0}, {5.0, 14.0}}) {
    const ImageHealth health = health_of(dim, bright);
    EXPECT_NEAR(led_peak_from_luma(health.dimmest_luma), dim, tolerance(dim));
    EXPECT_NEAR(led_peak_from_luma(health.peak_luma), bright, tolerance(bright));
    const ExposureMargin margin = exposure_margin(health.dimmest_luma, health.peak_luma);
    EXPECT_NEAR(margin.above_dim * 0.5, led_peak_from_luma(health.dimmest_luma), 1e-9);
    EXPECT_GT(margin.below_clipping, 1.0);
  }
}

TEST(ExposureMarginTest, ARenderedLedThatClipsInAllChannelsHasNoMargin) {
  const ImageHealth health = health_of(45.0, 60.0);
  EXPECT_LE(exposure_margin(health.dimmest_luma, health.peak_luma).below_clipping, 1.0);
}

TEST(ExposureMarginTest, APictureWithoutSpotsHasNoLumas) {
  SimulationSettings settings;
  settings.scene.lights.clear();
  const SimulatedWorld world = SimulatedWorld::create(settings).value();
  const RenderedFrame frame = render(world, Side::kLeft, Duration{0}, 0);
  LedDetector detector{LedDetectorSettings{}};
  const ImageHealth health = detector.detect(picture_of(frame_of(frame)), {}).health;
  EXPECT_EQ(health.peak_luma, 0.0);
  EXPECT_EQ(health.dimmest_luma, 0.0);
}

}  // namespace
}  // namespace tripoint
