#include "line/detect/coarse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "bench/painter.h"

namespace tripoint {
namespace {

bench::YuyvPicture random_picture(ImageSize size, std::uint32_t seed) {
  std::mt19937 random(seed);
  bench::YuyvPicture picture{.size = size, .bytes = {}};
  const auto bytes = static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 2;
  std::generate_n(std::back_inserter(picture.bytes), bytes,
                  [&] { return static_cast<std::uint8_t>(random() & 0xFFU); });
  return picture;
}

/// The definition: the largest V of the pixels in the cell.
int largest_v(const Picture& picture, int left, int top, int cell_px) {
  int largest = 0;
  for (int v = top; v < std::min(top + cell_px, picture.size.height_px); ++v) {
    for (int u = left; u < std::min(left + cell_px, picture.size.width_px); ++u) {
      largest = std::max<int>(largest, picture.v.at(u / 2, picture.chroma_rows_halved ? v / 2 : v));
    }
  }
  return largest;
}

void expect_map_of(const Picture& picture) {
  CoarseMap map;
  map.read(picture);
  int cell_px = 8;
  for (const CellMap& level : map.levels()) {
    ASSERT_EQ(level.columns(), (picture.size.width_px + cell_px - 1) / cell_px);
    ASSERT_EQ(level.rows(), (picture.size.height_px + cell_px - 1) / cell_px);
    for (int y = 0; y < level.rows(); ++y) {
      for (int x = 0; x < level.columns(); ++x) {
        ASSERT_EQ(level.row(y)[x], largest_v(picture, x * cell_px, y * cell_px, cell_px))
            << "cell " << x << ", " << y << " of " << cell_px << " px";
      }
    }
    cell_px *= 2;
  }
}

constexpr ImageSize kSizes[] = {{320, 240}, {640, 480}, {1280, 720}, {34, 22}, {678, 50}, {8, 8}, {2, 2}};

TEST(CoarseTest, EveryCellOfYuyvHoldsItsLargestV) {
  for (const ImageSize size : kSizes) expect_map_of(random_picture(size, 1).view());
}

TEST(CoarseTest, EveryCellOfPlanesWithHalfWidthChromaHoldsItsLargestV) {
  for (const ImageSize size : kSizes) expect_map_of(bench::planes_of(random_picture(size, 2), false).view());
}

TEST(CoarseTest, EveryCellOfPlanesWithHalfRowsOfChromaHoldsItsLargestV) {
  for (const ImageSize size : kSizes) expect_map_of(bench::planes_of(random_picture(size, 3), true).view());
}

TEST(CoarseTest, CellsOutsideThePictureStayDark) {
  CoarseMap map;
  const auto picture = random_picture({678, 50}, 4);
  map.read(picture.view());
  for (const CellMap& level : map.levels()) {
    for (int margin = 1; margin <= CellMap::kMargin; ++margin) {
      for (int y = -CellMap::kMargin; y < level.rows() + CellMap::kMargin; ++y) {
        EXPECT_EQ(level.row(y)[-margin], 0);
        EXPECT_EQ(level.row(y)[level.columns() - 1 + margin], 0);
      }
      EXPECT_EQ(level.row(-margin)[0], 0);
      EXPECT_EQ(level.row(level.rows() - 1 + margin)[0], 0);
    }
  }
}

TEST(CoarseTest, LargestCellsExistFrom640PixelsUp) {
  CoarseMap map;
  map.read(random_picture({320, 240}, 5).view());
  EXPECT_EQ(map.levels().size(), 2U);
  map.read(random_picture({640, 480}, 5).view());
  EXPECT_EQ(map.levels().size(), 3U);
}

TEST(CoarseDeathTest, PictureWithoutChromaIsABug) {
  Picture grey = random_picture({32, 32}, 6).view();
  grey.v = {};
  CoarseMap map;
  EXPECT_DEATH(map.read(grey), "is false");
}

}  // namespace
}  // namespace tripoint
