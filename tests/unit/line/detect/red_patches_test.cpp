#include "line/detect/red_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "bench/painter.h"

namespace tripoint {
namespace {

using bench::Color;
using bench::Ellipse;
using bench::Painting;

constexpr ImageSize kSize{320, 240};
constexpr Color kRedPaint{0.5, 0.03, 0.03};
constexpr double kGround = 0.1;

RedPatches patches_of(const Painting& painting) {
  std::mt19937 random(1);
  RedPatches patches;
  patches.read(painting.develop({}, random).view(), SphereSettings{});
  return patches;
}

Ellipse disc(double u_px, double v_px, double radius_px, Color color = kRedPaint) {
  return {.at = {u_px, v_px}, .half_width_px = radius_px, .half_height_px = radius_px, .color = color};
}

TEST(RedPatchesTest, ADiscIsOnePatchOfItsAreaAtItsPlace) {
  Painting painting(kSize, kGround);
  painting.add(disc(100.5, 80.5, 20.0));
  const auto found = patches_of(painting).at_least(10);
  ASSERT_EQ(found.size(), 1U);
  const double cells = std::numbers::pi * 20.0 * 20.0 / 4.0;
  EXPECT_NEAR(found[0].cells, cells, 0.5 * 20.0 * std::numbers::pi);  // half a cell all along the edge
  EXPECT_NEAR(found[0].left, 40, 1);
  EXPECT_NEAR(found[0].right, 60, 1);
  EXPECT_NEAR(found[0].top, 30, 1);
  EXPECT_NEAR(found[0].bottom, 50, 1);
}

TEST(RedPatchesTest, TheLargestComesFirstAndSmallOnesAreLeftOut) {
  Painting painting(kSize, kGround);
  painting.add(disc(60.5, 80.5, 10.0));
  painting.add(disc(160.5, 80.5, 20.0));
  painting.add(disc(260.5, 80.5, 3.0));
  const auto found = patches_of(painting).at_least(50);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GT(found[0].cells, found[1].cells);
  EXPECT_GT(found[0].left, found[1].left);
}

TEST(RedPatchesTest, WhatMeetsBelowIsOnePatch) {
  Painting painting(kSize, kGround);
  for (const double u_px : {60.5, 100.5, 140.5}) {  // three teeth of a comb
    painting.add(Ellipse{.at = {u_px, 80.5}, .half_width_px = 6.0, .half_height_px = 40.0, .color = kRedPaint});
  }
  EXPECT_EQ(patches_of(painting).at_least(10).size(), 3U);
  painting.add(Ellipse{.at = {100.5, 110.5}, .half_width_px = 60.0, .half_height_px = 6.0, .color = kRedPaint});
  const RedPatches joined = patches_of(painting);
  const auto found = joined.at_least(10);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(joined.label(30, 40), found[0].label);
  EXPECT_EQ(joined.label(70, 40), found[0].label);
  EXPECT_EQ(joined.label(40, 40), 0);
}

TEST(RedPatchesTest, OtherColoursAreNotRed) {
  const std::vector<std::pair<std::string, Color>> others{
      {"grey", {0.5, 0.5, 0.5}},   {"orange", {0.6, 0.2, 0.02}},  {"deep orange", {0.6, 0.08, 0.0}},
      {"skin", {0.7, 0.42, 0.3}},  {"magenta", {0.5, 0.03, 0.5}}, {"green", {0.03, 0.5, 0.03}},
      {"blue", {0.03, 0.03, 0.5}}, {"brown", {0.1, 0.05, 0.02}},  {"pink", {0.9, 0.55, 0.55}},
      {"black", {0.0, 0.0, 0.0}},
  };
  for (const auto& [what, color] : others) {
    Painting painting(kSize, kGround);
    painting.add(disc(100.5, 80.5, 20.0, color));
    EXPECT_TRUE(patches_of(painting).at_least(20).empty()) << what;
  }
}

TEST(RedPatchesTest, ARedPictureIsOnePatch) {
  Painting painting(kSize, kGround);
  painting.add(disc(160.0, 120.0, 300.0));
  const auto found = patches_of(painting).at_least(1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].cells, 160 * 120);
}

TEST(RedPatchesTest, OutsideThePictureNothingIsRed) {
  Painting painting(kSize, kGround);
  painting.add(disc(160.0, 120.0, 300.0));
  const RedPatches patches = patches_of(painting);
  EXPECT_EQ(patches.label(-1, 0), 0);
  EXPECT_EQ(patches.label(0, -1), 0);
  EXPECT_EQ(patches.label(160, 0), 0);
  EXPECT_EQ(patches.label(0, 120), 0);
  EXPECT_NE(patches.label(159, 119), 0);
}

TEST(RedPatchesTest, TheSamePlacesAreRedWithHalvedRowsOfChroma) {
  Painting painting(kSize, kGround);
  painting.add(disc(100.5, 80.5, 20.0));
  std::mt19937 random(1);
  const auto picture = painting.develop({}, random);
  RedPatches patches;
  patches.read(picture.view(), SphereSettings{});
  const int whole = patches.at_least(10).at(0).cells;
  patches.read(bench::planes_of(picture, true).view(), SphereSettings{});
  EXPECT_NEAR(patches.at_least(10).at(0).cells, whole, 20.0 * std::numbers::pi / 2.0);
}

}  // namespace
}  // namespace tripoint
