#include "line/detect/spot_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "bench/painter.h"

namespace tripoint {
namespace {

bench::YuyvPicture random_picture(ImageSize size) {
  std::mt19937 random(9);
  bench::YuyvPicture picture{.size = size, .bytes = {}};
  picture.bytes.resize(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 2);
  for (auto& byte : picture.bytes) byte = static_cast<std::uint8_t>(random() & 0xFFU);
  return picture;
}

/// S = 3 Y + 4 V', V' at a quarter of the way to the neighbouring chroma sample.
int strength_by_definition(const Picture& picture, int u, int v) {
  const int row = picture.chroma_rows_halved ? v / 2 : v;
  const int neighbour = std::clamp(u % 2 == 0 ? u / 2 - 1 : u / 2 + 1, 0, picture.size.width_px / 2 - 1);
  return 3 * picture.luma.at(u, v) + 3 * picture.v.at(u / 2, row) + picture.v.at(neighbour, row);
}

void expect_window_of(const Picture& picture, int center_u, int center_v, int half) {
  const auto window = std::make_unique<SpotWindow>();
  window->load(picture, center_u, center_v, half);
  ASSERT_LE(window->left_px(), center_u - half);
  ASSERT_GE(window->left_px() + window->columns() - 1, center_u + half);
  for (int row = 0; row < window->rows(); ++row) {
    for (int column = 0; column < window->columns(); ++column) {
      const int u = window->left_px() + column;
      const int v = window->top_px() + row;
      const std::size_t i = SpotWindow::index(column, row);
      const bool inside = u >= 0 && v >= 0 && u < picture.size.width_px && v < picture.size.height_px;
      ASSERT_EQ(window->outside(i), !inside) << u << ", " << v;
      if (!inside) continue;
      ASSERT_EQ(window->strength(i), strength_by_definition(picture, u, v)) << u << ", " << v;
      ASSERT_EQ(window->luma(i), picture.luma.at(u, v)) << u << ", " << v;
    }
  }
}

void expect_windows_of(const Picture& picture) {
  for (const int half : {8, 15, 40}) {
    for (const int u : {0, 1, 33, 62, 63}) {
      for (const int v : {0, 20, 47}) expect_window_of(picture, u, v, half);
    }
  }
}

TEST(SpotWindowTest, YuyvIsLoadedByDefinitionInsideAndAtEveryBorder) {
  const auto picture = random_picture({64, 48});
  expect_windows_of(picture.view());
}

TEST(SpotWindowTest, PlanesAreLoadedByDefinitionInsideAndAtEveryBorder) {
  const auto picture = random_picture({64, 48});
  expect_windows_of(bench::planes_of(picture, false).view());
  expect_windows_of(bench::planes_of(picture, true).view());
}

}  // namespace
}  // namespace tripoint
