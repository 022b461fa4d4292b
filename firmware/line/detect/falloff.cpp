#include "line/detect/falloff.h"

#include <algorithm>
#include <array>

#include "line/detect/vectors.h"

namespace tripoint {
namespace {

int rough_strength(const Picture& picture, int u_px, int v_px) {
  const int chroma_row = picture.chroma_rows_halved ? v_px / 2 : v_px;
  return 3 * picture.luma.at(u_px, v_px) + 4 * picture.v.at(u_px / 2, chroma_row);
}

bool in_picture(const Picture& picture, int u_px, int v_px) {
  return u_px >= 0 && v_px >= 0 && u_px < picture.size.width_px && v_px < picture.size.height_px;
}

constexpr int kReach = 2;  ///< columns and rows to every side in which the brightest is sought

/// Whether the rows around the start can be read four pairs at a time. A pair is one word: Y0 U Y1 V.
bool in_pairs(const Picture& picture, PixelPlace start) {
  return picture.interleaved_yuyv && start.u_px % 2 == 0 && start.u_px >= kReach &&
         start.u_px - kReach + 8 <= picture.size.width_px && start.v_px >= kReach &&
         start.v_px + kReach < picture.size.height_px;
}

int brightest_of_pairs(const Picture& picture, PixelPlace start) {
  Shorts8 brightest{};
  for (int v = start.v_px - kReach; v <= start.v_px + kReach; ++v) {
    const auto pairs = loaded<Words4>(picture.luma.row(v) + 2 * (start.u_px - kReach));
    const auto luma = reinterpret_cast<Shorts8>(pairs & 0x00FF00FFU);
    const Words4 red = pairs >> 24U;
    brightest = larger(brightest, luma + luma + luma + 4 * reinterpret_cast<Shorts8>(red | red << 16U));
  }
  return std::max({brightest[0], brightest[1], brightest[2], brightest[3], brightest[4]});
}

}  // namespace

int brightest_near(const Picture& picture, PixelPlace start) {
  if (in_pairs(picture, start)) return brightest_of_pairs(picture, start);
  const int left = std::max(start.u_px - kReach, 0);
  const int right = std::min(start.u_px + kReach, picture.size.width_px - 1);
  const int bottom = std::min(start.v_px + kReach, picture.size.height_px - 1);
  int brightest = 0;
  for (int v = std::max(start.v_px - kReach, 0); v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) brightest = std::max(brightest, rough_strength(picture, u, v));
  }
  return brightest;
}

std::optional<int> falloff_px(const Picture& picture, PixelPlace start, int level) {
  constexpr std::array<int, 4> kRadii{4, 8, 16, 30};
  constexpr std::array<std::array<int, 2>, 8> kDirections{
      {{10, 0}, {7, 7}, {0, 10}, {-7, 7}, {-10, 0}, {-7, -7}, {0, -10}, {7, -7}}};
  const auto* const found = std::find_if(kRadii.begin(), kRadii.end(), [&](int radius) {
    const auto low = std::count_if(kDirections.begin(), kDirections.end(), [&](const std::array<int, 2>& d) {
      const int u = start.u_px + d[0] * radius / 10;
      const int v = start.v_px + d[1] * radius / 10;
      return !in_picture(picture, u, v) || rough_strength(picture, u, v) < level;
    });
    return low >= 6;
  });
  return found == kRadii.end() ? std::nullopt : std::optional(*found);
}

}  // namespace tripoint
