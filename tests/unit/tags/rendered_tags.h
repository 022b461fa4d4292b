// Simulated cameras before a target of AprilTags.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "sim/renderer.h"
#include "sim/world.h"
#include "tags/tag_print.h"

namespace tripoint::test {

inline constexpr std::array<int, 3> kRenderedIds{0, 1, 2};
inline constexpr double kRenderedSize_mm = 32.0;
inline const std::array<Vec3, 3> kRenderedPlaces_mm{Vec3(0.0, 0.0, 0.0), Vec3(100.0, 0.0, 0.0), Vec3(64.0, 48.0, 0.0)};

/// Target from tag: printed on the side that looks along the target's +z.
inline Isometry3 target_from_tag(const Vec3& place_mm) {
  Isometry3 placed = Isometry3::Identity();
  placed.translation() = place_mm;
  placed.linear() = Vec3(1.0, -1.0, -1.0).asDiagonal();
  return placed;
}

/// Three tags before a grey wall, in light in which white paper is just below clipping.
inline SimulationSettings tagged_settings() {
  SimulationSettings settings;
  settings.scene.lights.clear();
  settings.scene.white_level = 0.9;
  settings.format = PixelFormat::kGrey;
  for (std::size_t i = 0; i < kRenderedIds.size(); ++i) {
    const Result<tripoint::TagCells> cells = tag_print("tag36h11", kRenderedIds[i]);
    EXPECT_TRUE(cells) << cells.error().message;
    settings.scene.tags.push_back({.id = kRenderedIds[i],
                                   .cells = *cells,
                                   .size_mm = kRenderedSize_mm,
                                   .target_from_tag = target_from_tag(kRenderedPlaces_mm[i])});
  }
  return settings;
}

}  // namespace tripoint::test
