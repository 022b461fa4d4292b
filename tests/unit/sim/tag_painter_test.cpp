#include "sim/tag_painter.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "still_world.h"

namespace tripoint {
namespace {

constexpr double kWhiteLevel = 0.9;
constexpr double kLight = kWhiteLevel * 0.8;
constexpr double kDark = kWhiteLevel * 0.04;
constexpr double kBack = kWhiteLevel * 0.3;

/// A dark square of 4 x 4 cells in a light frame of one; the cell right of the lower left corner's is light.
TagCells frame_cells() {
  TagCells cells{.across = 4, .total = 6, .light = std::vector<bool>(36, true)};
  for (int row = 1; row < 5; ++row) {
    for (int column = 1; column < 5; ++column) cells.light[static_cast<std::size_t>(6 * row + column)] = false;
  }
  cells.light[6 * 4 + 2] = true;
  return cells;
}

/// Lies as its target does; z runs away from the cameras, so that they see its front.
PrintedTag large_tag() { return {.id = 5, .cells = frame_cells(), .size_mm = 60.0}; }

SimulationSettings tagged(const PrintedTag& tag) {
  SimulationSettings settings = bare_settings();
  settings.scene.lights.clear();
  settings.scene.white_level = kWhiteLevel;
  settings.scene.tags = {tag};
  return settings;
}

Isometry3 tilted() {
  Isometry3 placed = Isometry3::Identity();
  placed.translation() = Vec3(30.0, -20.0, 10.0);
  placed.linear() = Eigen::AngleAxisd(0.6, Vec3(0.3, 0.9, 0.2).normalized()).toRotationMatrix();
  return placed;
}

/// One picture of a world; of places between pixels, linearly between the four around them.
class Seen {
 public:
  Seen(const SimulationSettings& settings, Side side) : world_(world_of(settings)), renderer_(world_, side) {
    truth_ = renderer_.render(kHalfWay, 0).truth;
  }
  [[nodiscard]] const TagTruth& tag(std::size_t index = 0) const { return truth_.tags[index]; }
  [[nodiscard]] const SimulatedWorld& world() const { return world_; }
  [[nodiscard]] double level(const RawPixel& at) const {
    const auto left = static_cast<std::size_t>(std::floor(at.u_px));
    const int top = static_cast<int>(std::floor(at.v_px));
    const auto row = [&](int y) {
      const auto levels = renderer_.light().row(y);
      return std::lerp(static_cast<double>(levels[left]), static_cast<double>(levels[left + 1]),
                       at.u_px - static_cast<double>(left));
    };
    return std::lerp(row(top), row(top + 1), at.v_px - top);
  }

 private:
  SimulatedWorld world_;
  FrameRenderer renderer_;
  FrameTruth truth_;
};

class TagInPictureTest : public ::testing::TestWithParam<Side> {
 protected:
  /// Of a place in cells from the middle of the tag.
  [[nodiscard]] double level(double across, double down) const {
    const Vec3 in_tag_mm(15.0 * across, 15.0 * down, 0.0);
    const Vec3 in_reference_mm = Vec3(0.0, 0.0, 400.0) + tag_.target_from_tag * in_tag_mm;
    const Rig& rig = seen_.world().rig();
    return seen_.level(projected(rig.cameras[GetParam()], rig.camera_from_rig[GetParam()] * in_reference_mm).value());
  }

  PrintedTag tag_ = [] {
    PrintedTag tag = large_tag();
    tag.target_from_tag = tilted();
    return tag;
  }();
  Seen seen_{tagged(tag_), GetParam()};
};

TEST_P(TagInPictureTest, CellsAreLightAndDarkAsPrinted) {
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      EXPECT_NEAR(level(column - 2.5, row - 2.5), tag_.cells.is_light(column, row) ? kLight : kDark, 1e-4)
          << row << " " << column;
    }
  }
}

/// In the middle of an edge the level is that between both cells. Its slope there is (light - dark) / (sigma
/// sqrt(2 pi)), about half of the contrast a pixel: a place wrong by 0.02 px would be seen.
TEST_P(TagInPictureTest, EdgesLieWhereTheCameraProjectsThem) {
  const double middle = 0.5 * (kLight + kDark);
  const double tolerance = 0.01 * (kLight - kDark);
  for (const double along : {-1.5, 0.5, 1.5}) {
    EXPECT_NEAR(level(along, -2.0), middle, tolerance) << along;
    EXPECT_NEAR(level(along, 2.0), middle, tolerance) << along;
    EXPECT_NEAR(level(-2.0, along), middle, tolerance) << along;
    EXPECT_NEAR(level(2.0, along), middle, tolerance) << along;
  }
  EXPECT_NEAR(level(-3.0, 0.5), 0.5 * kLight, tolerance);  // the end of the paper, before a black wall
}

TEST_P(TagInPictureTest, NothingIsDrawnBesideThePaper) {
  EXPECT_EQ(level(-3.5, 0.0), 0.0);
  EXPECT_EQ(level(0.0, 3.5), 0.0);
}

TEST_P(TagInPictureTest, TheTruthIsWhereTheCornersOfTheDarkSquareAreProjected) {
  const Rig& rig = seen_.world().rig();
  const std::array<Vec2, kTagCorners> places{Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1)};
  EXPECT_EQ(seen_.tag().id, 5);
  EXPECT_TRUE(seen_.tag().front && seen_.tag().visible);
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    const Vec3 in_reference_mm =
        Vec3(0.0, 0.0, 400.0) + tag_.target_from_tag * Vec3(30.0 * places[k].x(), 30.0 * places[k].y(), 0.0);
    const RawPixel at = projected(rig.cameras[GetParam()], rig.camera_from_rig[GetParam()] * in_reference_mm).value();
    EXPECT_NEAR(seen_.tag().corners_px[k].u_px, at.u_px, 1e-9);
    EXPECT_NEAR(seen_.tag().corners_px[k].v_px, at.v_px, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(BothCameras, TagInPictureTest, ::testing::Values(Side::kLeft, Side::kRight));

/// Three of the cells around a corner of the square are light.
TEST(TagPainterTest, WithARollingShutterTheTruthIsWhereThePictureHasItsCorners) {
  SimulationSettings settings = tagged(large_tag());
  settings.trajectory = straight({0.0, 0.0, 400.0}, {400.0, 300.0, 0.0});
  settings.line_time = std::chrono::microseconds{60};
  const Seen seen(settings, Side::kLeft);
  settings.line_time = Duration{0};
  const Seen at_once(settings, Side::kLeft);
  const double expected = 0.75 * kLight + 0.25 * kDark;
  for (std::size_t k = 0; k < kTagCorners; ++k) {
    EXPECT_GT(seen.tag().corners_px[k].u_px, at_once.tag().corners_px[k].u_px + 5.0);  // row 180 is 11 ms later
    EXPECT_NEAR(seen.level(seen.tag().corners_px[k]), expected, 0.02 * (kLight - kDark)) << k;
  }
}

/// The edge runs over 12.6 px while it is exposed, so a place at a quarter of its path is light for a quarter of the
/// time.
TEST(TagPainterTest, AnEdgeIsDrawnOutAlongItsPath) {
  SimulationSettings settings = tagged(large_tag());
  settings.trajectory = straight({0.0, 0.0, 400.0}, {800.0, 0.0, 0.0});
  settings.exposure = std::chrono::milliseconds{10};
  const Seen seen(settings, Side::kLeft);
  const auto& corners = seen.tag().corners_px;
  const RawPixel upper = corners[3];
  const RawPixel lower = corners[0];
  for (const double share : {0.25, 0.5, 0.75}) {
    const double path_px = 628.0 * 8.0 / 400.0;
    const RawPixel at{.u_px = std::lerp(upper.u_px, lower.u_px, 0.4) + (share - 0.5) * path_px,
                      .v_px = std::lerp(upper.v_px, lower.v_px, 0.4)};
    EXPECT_NEAR(seen.level(at), std::lerp(kLight, kDark, share), 0.03 * (kLight - kDark)) << share;
  }
}

TEST(TagPainterTest, FromBehindOnlyThePlainSideIsSeen) {
  PrintedTag tag = large_tag();
  tag.target_from_tag.linear() = Vec3(1.0, -1.0, -1.0).asDiagonal();
  const Seen seen(tagged(tag), Side::kLeft);
  EXPECT_FALSE(seen.tag().front);
  const auto& corners = seen.tag().corners_px;
  for (const double share : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR(seen.level({std::lerp(corners[0].u_px, corners[2].u_px, share),
                            std::lerp(corners[0].v_px, corners[2].v_px, share)}),
                kBack, 1e-4);
  }
}

TEST(TagPainterTest, TheNearerTagHidesTheFartherOneWhateverTheirOrder) {
  PrintedTag far = large_tag();
  PrintedTag near = large_tag();
  far.target_from_tag.translation() = Vec3(0.0, 0.0, 50.0);
  near.target_from_tag.linear() = Vec3(1.0, -1.0, -1.0).asDiagonal();
  for (const auto& tags : {std::vector{far, near}, std::vector{near, far}}) {
    SimulationSettings settings = tagged(near);
    settings.scene.tags = tags;
    const Seen seen(settings, Side::kLeft);
    EXPECT_NEAR(seen.level(seen.tag(0).corners_px[0]), kBack, 1e-4);
  }
}

TEST(TagPainterTest, EdgeOnNothingIsSeen) {
  PrintedTag tag = large_tag();
  SimulationSettings settings = tagged(tag);
  const Rig rig = *rig_of(settings.rig);
  // In a plane with the left camera's centre.
  settings.trajectory = straight(rig.camera_from_rig.left.inverse() * Vec3(0.0, 0.0, 400.0), Vec3::Zero());
  settings.scene.tags[0].target_from_tag.linear() =
      (rig.camera_from_rig.left.inverse().linear() * Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY())).matrix();
  const Seen seen(settings, Side::kLeft);
  EXPECT_FALSE(seen.tag().front);
  EXPECT_EQ(seen.level({322.3, 237.8}), 0.0);
}

TEST(TagPainterTest, ATagThatLeavesThePictureIsDrawnUpToItsBorder) {
  SimulationSettings settings = tagged(large_tag());
  settings.trajectory = straight({-190.0, 0.0, 400.0}, Vec3::Zero());
  const Seen seen(settings, Side::kRight);
  EXPECT_FALSE(seen.tag().visible);
  EXPECT_GT(seen.level({1.0, seen.tag().corners_px[1].v_px - 30.0}), 0.9 * kDark);
}

TEST(TagPainterTest, ATagBehindTheCamerasIsNeitherDrawnNorVisible) {
  SimulationSettings settings = tagged(large_tag());
  settings.trajectory = straight({0.0, 0.0, -400.0}, Vec3::Zero());
  const SimulatedWorld world = world_of(settings);
  FrameRenderer renderer(world, Side::kLeft);
  EXPECT_FALSE(renderer.render(kHalfWay, 0).truth.tags[0].visible);
  for (int y = 0; y < 480; ++y) {
    for (const float level : renderer.light().row(y)) ASSERT_EQ(level, 0.0F);
  }
}

TEST(TagPainterTest, WhatWasDrawnIsGoneWhenTheTagHasMovedOn) {
  SimulationSettings settings = tagged(large_tag());
  settings.trajectory = straight({0.0, 0.0, 400.0}, {100.0, 0.0, 0.0});
  const SimulatedWorld world = world_of(settings);
  FrameRenderer moved(world, Side::kLeft);
  moved.render(kHalfWay - std::chrono::seconds{1}, 0);
  moved.render(kHalfWay, 0);
  FrameRenderer fresh(world, Side::kLeft);
  fresh.render(kHalfWay, 0);
  for (int y = 0; y < 480; ++y) ASSERT_TRUE(std::ranges::equal(moved.light().row(y), fresh.light().row(y))) << y;
}

}  // namespace
}  // namespace tripoint
