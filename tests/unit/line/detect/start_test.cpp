#include "line/detect/start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "bench/painter.h"
#include "line/detect/falloff.h"

namespace tripoint {
namespace {

constexpr ImageSize kSize{60, 44};  // the last column and the last row of cells are cut

/// Few different values: nearly every cell has equals.
bench::YuyvPicture picture_of_few_values() {
  std::mt19937 random(3);
  bench::YuyvPicture picture{.size = kSize, .bytes = {}};
  picture.bytes.resize(static_cast<std::size_t>(kSize.width_px) * static_cast<std::size_t>(kSize.height_px) * 2);
  for (auto& byte : picture.bytes) byte = static_cast<std::uint8_t>(90U * (random() % 3U) + 75U);
  return picture;
}

int red_at(const Picture& picture, int u, int v) { return picture.v.at(u / 2, picture.chroma_rows_halved ? v / 2 : v); }

/// The first of the largest in reading order; each chroma sample counts once, with its first pixel's luma.
PixelPlace reddest_by_definition(const Picture& picture, int left, int top) {
  PixelPlace best{left, top};
  for (int v = top; v < std::min(top + CoarseMap::kCellPx, kSize.height_px); v += picture.chroma_rows_halved ? 2 : 1) {
    for (int u = left; u < std::min(left + CoarseMap::kCellPx, kSize.width_px); u += 2) {
      const int more = red_at(picture, u, v) - red_at(picture, best.u_px, best.v_px);
      const bool brighter = picture.luma.at(u, v) > picture.luma.at(best.u_px, best.v_px);
      if (more > 0 || (more == 0 && brighter)) best = {u, v};
    }
  }
  return best;
}

void expect_starts_by_definition(const Picture& picture) {
  CoarseMap map;
  map.read(picture);
  for (int v = 0; v < kSize.height_px; v += CoarseMap::kCellPx) {
    for (int u = 0; u < kSize.width_px; u += CoarseMap::kCellPx) {
      const Cell cell{.u_px = static_cast<std::int16_t>(u),
                      .v_px = static_cast<std::int16_t>(v),
                      .size_px = CoarseMap::kCellPx,
                      .contrast = 0};
      const PixelPlace start = reddest_of_cell(picture, map, cell);
      const PixelPlace expected = reddest_by_definition(picture, u, v);
      EXPECT_EQ(start.u_px, expected.u_px) << "cell at " << u << ", " << v;
      EXPECT_EQ(start.v_px, expected.v_px) << "cell at " << u << ", " << v;
    }
  }
}

void expect_brightest_by_definition(const Picture& picture) {
  for (int v = 0; v < kSize.height_px; ++v) {
    for (int u = 0; u < kSize.width_px; ++u) {
      int brightest = 0;
      for (int y = std::max(v - 2, 0); y <= std::min(v + 2, kSize.height_px - 1); ++y) {
        for (int x = std::max(u - 2, 0); x <= std::min(u + 2, kSize.width_px - 1); ++x) {
          brightest = std::max(brightest, 3 * picture.luma.at(x, y) + 4 * red_at(picture, x, y));
        }
      }
      ASSERT_EQ(brightest_near(picture, {u, v}), brightest) << u << ", " << v;
    }
  }
}

TEST(StartTest, IsTheReddestPixelOfTheCellAndTheBrightestOfEquals) {
  const auto picture = picture_of_few_values();
  expect_starts_by_definition(picture.view());
  expect_starts_by_definition(bench::planes_of(picture, false).view());
  expect_starts_by_definition(bench::planes_of(picture, true).view());
}

TEST(StartTest, TheBrightestIsSoughtWithinTwoPixels) {
  const auto picture = picture_of_few_values();
  expect_brightest_by_definition(picture.view());
  expect_brightest_by_definition(bench::planes_of(picture, false).view());
  expect_brightest_by_definition(bench::planes_of(picture, true).view());
}

}  // namespace
}  // namespace tripoint
