#include "app/detector_settings.h"

#include <gtest/gtest.h>

#include <variant>

namespace tripoint {
namespace {

TEST(DetectorSettingsTest, TheKindChooses) {
  DetectorConfig config;
  EXPECT_TRUE(std::holds_alternative<LedDetectorSettings>(detector_settings(config)));
  config.kind = ConfiguredDetector::kSphere;
  EXPECT_TRUE(std::holds_alternative<SphereSettings>(detector_settings(config)));
}

TEST(DetectorSettingsTest, AnEmptyTableOfSpheresIsTheDetectorsDefaults) {
  const SphereSettings settings = sphere_settings({});
  EXPECT_EQ(settings.min_radius_px, SphereSettings{}.min_radius_px);
  EXPECT_EQ(settings.max_radius_px, SphereSettings{}.max_radius_px);
  EXPECT_EQ(settings.min_redness, SphereSettings{}.min_redness);
  EXPECT_EQ(settings.min_fill, SphereSettings{}.min_fill);
}

TEST(DetectorSettingsTest, WhatIsConfiguredForSpheresArrives) {
  DetectorConfig config;
  config.min_radius_px = 21.0;
  config.max_radius_px = 71.0;
  config.min_redness = 0.45;
  config.min_fill = 0.55;
  const SphereSettings settings = sphere_settings(config);
  EXPECT_EQ(settings.min_radius_px, 21.0);
  EXPECT_EQ(settings.max_radius_px, 71.0);
  EXPECT_EQ(settings.min_redness, 0.45);
  EXPECT_EQ(settings.min_fill, 0.55);
}

}  // namespace
}  // namespace tripoint
