#include "tags/luma_view.h"

#include <gtest/gtest.h>

#include <vector>

namespace tripoint {
namespace {

constexpr int kWidth_px = 6;
constexpr int kHeight_px = 5;

/// Luma 10 u + 20 v in every `step_bytes`th byte, other bytes at 255, with two bytes between the rows.
struct Ramp {
  explicit Ramp(std::size_t step) : step_bytes(step), stride_bytes(kWidth_px * step + 2) {
    bytes.assign(stride_bytes * kHeight_px, 255);
    for (std::size_t v = 0; v < kHeight_px; ++v) {
      for (std::size_t u = 0; u < kWidth_px; ++u) {
        bytes[v * stride_bytes + u * step] = static_cast<std::uint8_t>(10 * u + 20 * v);
      }
    }
  }
  [[nodiscard]] LumaView view() const {
    return {{.data = bytes.data(), .stride_bytes = stride_bytes, .step_bytes = step_bytes},
            {.width_px = kWidth_px, .height_px = kHeight_px}};
  }
  std::size_t step_bytes;
  std::size_t stride_bytes;
  std::vector<std::uint8_t> bytes;
};

TEST(LumaViewTest, BetweenPixelsLumaIsBilinearInEveryLayout) {
  for (const std::size_t step : {1U, 2U}) {
    const Ramp ramp(step);
    for (const Vec2& place : {Vec2(0.0, 0.0), Vec2(1.25, 2.5), Vec2(4.9, 3.9)}) {
      const auto luma = ramp.view().at(place);
      ASSERT_TRUE(luma);
      EXPECT_NEAR(*luma, 10.0 * place.x() + 20.0 * place.y(), 1e-4);
    }
  }
}

TEST(LumaViewTest, AProfileIsSampledFromTheFirstPlaceToTheLast) {
  const Ramp ramp(2);
  const auto profile = ramp.view().along({4.5, 0.5}, {0.5, 3.5}, 5);
  ASSERT_TRUE(profile);
  ASSERT_EQ(profile->size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR((*profile)[i], 10.0 * (4.5 - static_cast<double>(i)) + 20.0 * (0.5 + 0.75 * static_cast<double>(i)),
                1e-4);
  }
}

TEST(LumaViewTest, OutsideOfThePictureThereIsNothing) {
  const Ramp ramp(1);
  const LumaView view = ramp.view();
  for (const Vec2& place :
       {Vec2(-0.01, 1.0), Vec2(1.0, -0.01), Vec2(5.0, 1.0), Vec2(1.0, 4.0), Vec2(1e12, 1.0), Vec2(std::nan(""), 1.0)}) {
    EXPECT_FALSE(view.at(place)) << place.transpose();
    EXPECT_FALSE(view.along({2.0, 2.0}, place, 4)) << place.transpose();
    EXPECT_FALSE(view.along(place, {2.0, 2.0}, 4)) << place.transpose();
  }
}

}  // namespace
}  // namespace tripoint
