#include "explain/canvas.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tripoint {
namespace {

constexpr Colour kBlack{0, 0, 0};
constexpr Colour kWhite{255, 255, 255};
constexpr Type kType{kWhite, 12.0};

Canvas with_line(double y, double width_px) {
  Canvas canvas({20, 20}, kBlack);
  const std::array<Stroke, 1> line{Stroke{{2.0, y}, {17.0, y}}};
  canvas.draw(line, {kWhite, width_px});
  return canvas;
}

TEST(CanvasTest, ALineOfThreePixelsCoversThreeRows) {
  const RgbImage image = with_line(10.0, 3.0).image();
  for (const int y : {9, 10, 11}) EXPECT_EQ(image.at(10, y), kWhite);
  for (const int y : {8, 12}) EXPECT_EQ(image.at(10, y), kBlack);
}

TEST(CanvasTest, ALineBetweenTwoRowsIsHalfInBoth) {
  const RgbImage image = with_line(10.5, 1.0).image();
  EXPECT_EQ(image.at(10, 10), (Colour{128, 128, 128}));
  EXPECT_EQ(image.at(10, 11), (Colour{128, 128, 128}));
}

TEST(CanvasTest, AHaloIsDarkAroundTheLine) {
  Canvas canvas({20, 20}, kWhite);
  const std::array<Stroke, 1> line{Stroke{{2.0, 10.0}, {17.0, 10.0}}};
  canvas.draw(line, {{255, 0, 0}, 1.0, 2.0});
  EXPECT_EQ(canvas.image().at(10, 10), (Colour{255, 0, 0}));
  EXPECT_LT(canvas.image().at(10, 12).green, 80);
  EXPECT_EQ(canvas.image().at(10, 14), kWhite);
}

TEST(CanvasTest, WhatLiesOutsideIsLeftOut) {
  Canvas canvas({20, 20}, kBlack);
  const std::array<Stroke, 2> strokes{circle({0.0, 0.0}, 5.0), circle({1e9, -1e9}, 1e9)};
  canvas.draw(std::span(strokes).first(1), {kWhite, 1.0});
  canvas.draw(std::span(strokes).last(1), {kWhite, 1.0});
  canvas.fill({-5.0, 18.0, 50.0, 70.0}, {0, 0, 99}, 1.0);
  canvas.place(plain_image({4, 4}, {0, 77, 0}), 18, -2);
  canvas.write("beyond", {15.0, 17.0}, kType);
  EXPECT_EQ(canvas.image().at(5, 0), kWhite);
  EXPECT_EQ(canvas.image().at(0, 19), (Colour{0, 0, 99}));
  EXPECT_EQ(canvas.image().at(19, 1).green, 77);
  EXPECT_EQ(canvas.image().at(10, 12), kBlack);
}

TEST(CanvasTest, AnEllipseLiesAtItsHalfAxes) {
  Canvas canvas({41, 41}, kBlack);
  const std::array<Stroke, 1> strokes{ellipse({20.0, 20.0}, {15.0, 5.0, M_PI / 2.0})};
  canvas.draw(strokes, {kWhite, 2.0});
  EXPECT_EQ(canvas.image().at(20, 5).red, 255);  // the long axis points down
  EXPECT_EQ(canvas.image().at(25, 20).red, 255);
  EXPECT_EQ(canvas.image().at(35, 20), kBlack);
}

TEST(CanvasTest, LettersStandOnTheirLineAndAreAsWideAsTold) {
  Canvas canvas({200, 40}, kBlack);
  canvas.write("HIM", {10.0, 30.0}, kType);
  int right = 0;
  int top = 40;
  int bottom = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (canvas.image().at(x, y).red < 128) continue;
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  EXPECT_NEAR(right, 10.0 + text_width_px("HIM", kType), 1.5);  // half a stroke
  EXPECT_NEAR(bottom - top, 12.0, 1.5);
  EXPECT_NEAR(bottom, 30, 1);
}

TEST(CanvasTest, TextThatFitsIsWhole) {
  EXPECT_EQ(fitting_text("picture.png", kType, text_width_px("picture.png", kType)), "picture.png");
}

TEST(CanvasTest, TextThatIsTooWideEndsInDots) {
  const std::string text = fitting_text("a very long name of a picture.png", kType, 150.0);
  EXPECT_TRUE(text.starts_with("a very"));
  EXPECT_TRUE(text.ends_with("..."));
  EXPECT_LE(text_width_px(text, kType), 150.0);
  EXPECT_EQ(fitting_text("abc", kType, 0.0), "...");
}

}  // namespace
}  // namespace tripoint
