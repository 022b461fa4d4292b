#include "sim/developing.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene.h"

namespace tripoint {
namespace {

constexpr ImageSize kSize{.width_px = 32, .height_px = 16};
constexpr SensorModel kQuiet{.read_noise = 0.0, .full_well_electrons = 1e30};

/// A noiseless plane in which pixel (x, y) of channel c has the level `level(x, y, c)`.
template <typename Level>
RawPlane plane_of(const Level& level) {
  RawPlane plane(kSize);
  const std::vector<float> silence(32, 0.0F);
  for (int y = 0; y < kSize.height_px; ++y) {
    std::vector<float> row(32);
    for (int x = 0; x < kSize.width_px; ++x) {
      row[static_cast<std::size_t>(x)] = static_cast<float>(level(x, y, bayer_channel(x, y)));
    }
    plane.expose_row(y, row, silence, kQuiet);
  }
  return plane;
}

YuvPlanes developed(const RawPlane& raw, YuvRange range, const Tone& tone = {}) {
  Developer developer(kSize, range, tone);
  developer.develop(raw);
  return developer.planes();
}

struct ColourBar {
  LinearColor rgb;
  std::array<int, 3> yuv;
};

void expect_uniform(const ColourBar& bar, YuvRange range) {
  const YuvPlanes planes = developed(plane_of([&](int, int, std::size_t c) { return bar.rgb[c]; }), range);
  for (const std::uint8_t y : planes.y) ASSERT_EQ(y, bar.yuv[0]);
  for (const std::uint8_t u : planes.u) ASSERT_EQ(u, bar.yuv[1]);
  for (const std::uint8_t v : planes.v) ASSERT_EQ(v, bar.yuv[2]);
}

// The 8-bit values of 100 % colour bars in ITU-R BT.601.
TEST(DevelopingTest, UniformColoursBecomeTheColourBarsOfBt601) {
  const std::vector<ColourBar> bars{{{1, 1, 1}, {235, 128, 128}}, {{1, 1, 0}, {210, 16, 146}},
                                    {{0, 1, 1}, {170, 166, 16}},  {{0, 1, 0}, {145, 54, 34}},
                                    {{1, 0, 1}, {106, 202, 222}}, {{1, 0, 0}, {81, 90, 240}},
                                    {{0, 0, 1}, {41, 240, 110}},  {{0, 0, 0}, {16, 128, 128}}};
  for (const ColourBar& bar : bars) expect_uniform(bar, YuvRange::kVideo);
}

// JFIF 1.02: the same matrix over the whole byte.
TEST(DevelopingTest, JpegUsesTheWholeByte) {
  expect_uniform({{1, 1, 1}, {255, 128, 128}}, YuvRange::kFull);
  expect_uniform({{0, 0, 0}, {0, 128, 128}}, YuvRange::kFull);
  expect_uniform({{1, 0, 0}, {76, 85, 255}}, YuvRange::kFull);
}

TEST(DevelopingTest, LinearRampIsReproducedByBilinearInterpolation) {
  const auto ramp = [](int x, int y) { return (100.0 + 8.0 * x + 12.0 * y) / kClipCounts; };
  const YuvPlanes planes = developed(plane_of([&](int x, int y, std::size_t) { return ramp(x, y); }), YuvRange::kVideo);
  for (int y = 1; y < kSize.height_px - 1; ++y) {
    for (int x = 1; x < kSize.width_px - 1; ++x) {
      const double luma = 16.0 + 219.0 * ramp(x, y);
      ASSERT_NEAR(planes.y[static_cast<std::size_t>(32 * y + x)], luma, 0.51) << x << ' ' << y;  // rounding
    }
  }
}

TEST(DevelopingTest, ChromaIsTheMeanOfItsTwoPixels) {
  // Red rises by 4 counts a pixel: V follows it at the middle of a pair, with 112 at clip.
  const auto red = [](double x) { return (200.0 + 4.0 * x) / kClipCounts; };
  const YuvPlanes planes =
      developed(plane_of([&](int x, int, std::size_t c) { return c == 0 ? red(x) : 0.0; }), YuvRange::kVideo);
  for (int pair = 1; pair < 15; ++pair) {
    const double v = 128.0 + 112.0 * red(2.0 * pair + 0.5);
    ASSERT_NEAR(planes.v[static_cast<std::size_t>(5 * 16 + pair)], v, 0.51) << pair;
  }
}

TEST(DevelopingTest, DarkNoiseBelowBlackIsCutNotWrapped) {
  const YuvPlanes planes = developed(plane_of([](int, int, std::size_t) { return -0.06; }), YuvRange::kFull);
  for (const std::uint8_t y : planes.y) ASSERT_EQ(y, 0);
}

TEST(DevelopingTest, YuyvHasLumaAndChromaInTurn) {
  YuvPlanes planes{.size = {.width_px = 4, .height_px = 1}, .y = {1, 2, 3, 4}, .u = {10, 11}, .v = {20, 21}};
  YuyvPacker packer(planes.size);
  packer.pack(planes);
  EXPECT_EQ(packer.bytes(), (std::vector<std::uint8_t>{1, 10, 2, 20, 3, 11, 4, 21}));
}

std::uint8_t luma_of_grey(double level, const Tone& tone) {
  return developed(plane_of([&](int, int, std::size_t) { return level; }), YuvRange::kVideo, tone).y[0];
}

TEST(DevelopingTest, GammaIsThePowerLaw) {
  for (const double level : {0.0, 0.05, 0.18, 0.5, 1.0}) {
    const double counted = std::round(level * kClipCounts) / kClipCounts;
    EXPECT_NEAR(luma_of_grey(level, {.gamma = 2.2}), 16.0 + 219.0 * std::pow(counted, 1.0 / 2.2), 0.51) << level;
  }
}

TEST(DevelopingTest, ColourMatrixTurnsColoursAndKeepsGrey) {
  Tone tone;
  tone.color_matrix << 1.5, -0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  EXPECT_EQ(luma_of_grey(0.4, tone), luma_of_grey(0.4, {}));
  const LinearColor color{0.4, 0.2, 0.1};
  const RawPlane raw = plane_of([&](int, int, std::size_t c) { return color[c]; });
  // red 1.5 x 0.4 - 0.5 x 0.2 = 0.5; BT.601 by hand
  const double luma = 0.299 * 0.5 + 0.587 * 0.2 + 0.114 * 0.1;
  const YuvPlanes planes = developed(raw, YuvRange::kVideo, tone);
  EXPECT_NEAR(planes.y[100], 16.0 + 219.0 * luma, 0.8);  // counts are whole: 0.2 of a step more than rounding
  EXPECT_NEAR(planes.v[50], 128.0 + 112.0 * (0.5 - luma) / 0.701, 0.8);
}

TEST(DevelopingTest, ColoursThatTheMatrixMakesNegativeAreBlack) {
  Tone tone{.gamma = 2.2};
  tone.color_matrix << 1.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  const RawPlane raw = plane_of([](int, int, std::size_t c) { return c == 0 ? 1.0 : 0.0; });
  EXPECT_EQ(developed(raw, YuvRange::kVideo, tone).y[100], 81);  // pure red of the colour bars
}

TEST(DevelopingTest, WebcamToneKeepsWhiteAndBlack) {
  EXPECT_EQ(luma_of_grey(1.0, webcam_tone()), 235);
  EXPECT_EQ(luma_of_grey(0.0, webcam_tone()), 16);
}

}  // namespace
}  // namespace tripoint
