// A grey picture with one red square: S = 3 Y + 4 V follows from the bytes.
#include "modulation/place_light.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace tripoint {
namespace {

constexpr ImageSize kSize{64, 48};

struct Yuyv {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(static_cast<std::size_t>(2 * 64 * 48), 128);

  Yuyv() {
    for (std::size_t i = 0; i < bytes.size(); i += 2) bytes[i] = 20;
  }
  /// Pixels left to left + 5, top to top + 5.
  void add_red_square(std::size_t left, std::size_t top) {
    for (std::size_t v = top; v <= top + 5; ++v) {
      for (std::size_t u = left; u <= left + 5; ++u) {
        bytes[2 * (64 * v + u)] = 80;
        bytes[2 * (64 * v + u / 2 * 2) + 3] = 200;
      }
    }
  }
  [[nodiscard]] Picture picture() const {
    return picture_of(Frame{.side = Side::kLeft,
                            .format = PixelFormat::kYuyv,
                            .size = kSize,
                            .stride_bytes = 2 * 64,
                            .data = bytes,
                            .sequence = 0,
                            .exposed = {},
                            .arrived = {},
                            .line_time = {}});
  }
};

TEST(PlaceLightTest, IsTheStrengthAboveTheRing) {
  Yuyv yuyv;
  yuyv.add_red_square(28, 20);
  PlaceLight light;
  const auto contrast = light.contrast(yuyv.picture(), {30.5, 22.5}, 3.0);
  ASSERT_TRUE(contrast);
  EXPECT_NEAR(*contrast, 3 * (80 - 20) + 4 * (200 - 128), 2) << "S = 3 Y + 4 V; chroma is interpolated between pixels";
}

TEST(PlaceLightTest, ADarkPlaceHasNone) {
  const Yuyv yuyv;
  PlaceLight light;
  EXPECT_EQ(light.contrast(yuyv.picture(), {30.5, 22.5}, 3.0), 0);
}

TEST(PlaceLightTest, LightAnywhereWithinTheRadiusCounts) {
  Yuyv yuyv;
  yuyv.add_red_square(28, 20);
  PlaceLight light;
  EXPECT_GT(light.contrast(yuyv.picture(), {37.5, 22.5}, 6.0).value(), 300);
  EXPECT_LT(light.contrast(yuyv.picture(), {44.5, 22.5}, 6.0).value(), 50);
}

TEST(PlaceLightTest, AtTheBorderNothingIsKnown) {
  const Yuyv yuyv;
  PlaceLight light;
  EXPECT_TRUE(light.contrast(yuyv.picture(), {7.0, 20.0}, 3.0)) << "radius 3 and the ring 4 beyond it";
  EXPECT_FALSE(light.contrast(yuyv.picture(), {6.9, 20.0}, 3.0));
  EXPECT_FALSE(light.contrast(yuyv.picture(), {30.0, 40.1}, 3.0));
}

}  // namespace
}  // namespace tripoint
