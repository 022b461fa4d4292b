#include "line/detect/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tripoint {
namespace {

/// Counts values of a byte, for a value of a given rank.
class Levels {
 public:
  void add(int level) {
    ++counts_[static_cast<std::size_t>(level)];
    ++n_;
  }
  /// The level below which `share` of all lie; 0 when there are none.
  [[nodiscard]] int at(double share) const {
    int left = static_cast<int>(n_ * share);
    std::size_t level = 0;
    while (level + 1 < counts_.size() && left >= counts_[level]) left -= counts_[level++];
    return n_ == 0 ? 0 : static_cast<int>(level);
  }

 private:
  std::array<int, 256> counts_{};
  int n_ = 0;
};

/// Directions to sixteen places around a spot.
constexpr std::array<std::array<float, 2>, 16> kAround{{{1.0F, 0.0F},
                                                        {0.924F, 0.383F},
                                                        {0.707F, 0.707F},
                                                        {0.383F, 0.924F},
                                                        {0.0F, 1.0F},
                                                        {-0.383F, 0.924F},
                                                        {-0.707F, 0.707F},
                                                        {-0.924F, 0.383F},
                                                        {-1.0F, 0.0F},
                                                        {-0.924F, -0.383F},
                                                        {-0.707F, -0.707F},
                                                        {-0.383F, -0.924F},
                                                        {0.0F, -1.0F},
                                                        {0.383F, -0.924F},
                                                        {0.707F, -0.707F},
                                                        {0.924F, -0.383F}}};

int chroma_row(const Picture& picture, int v_px) { return picture.chroma_rows_halved ? v_px / 2 : v_px; }

/// Median of U at those of the sixteen places that lie in the picture; grey when none does.
int blue_around(const Picture& picture, const Candidate& candidate) {
  constexpr float kBeyond_px = 3.0F;  // the middle of the ring in which the gates know the surroundings
  const float reach_px = 2.0F * candidate.radius_px + kBeyond_px;
  const auto center_u = static_cast<float>(candidate.at.u_px) + 0.5F;
  const auto center_v = static_cast<float>(candidate.at.v_px) + 0.5F;
  std::array<int, kAround.size()> blue{};
  std::size_t n = 0;
  for (const auto& [along_u, along_v] : kAround) {
    const int u = static_cast<int>(std::floor(center_u + reach_px * along_u));
    const int v = static_cast<int>(std::floor(center_v + reach_px * along_v));
    const bool inside = u >= 0 && v >= 0 && u < picture.size.width_px && v < picture.size.height_px;
    if (inside) blue[n++] = picture.u.at(u / 2, chroma_row(picture, v));
  }
  if (n == 0) return 128;
  auto* const middle = blue.begin() + n / 2;
  std::nth_element(blue.begin(), middle, blue.begin() + n);
  return *middle;
}

struct Flank {
  int blue = 0;  ///< sums of U and V
  int red = 0;
  int pixels = 0;
};

/// The pixels within a radius whose strength lies between two; of each pair that shares its chroma, the left one.
Flank flank_of(const Picture& picture, const Candidate& candidate, std::array<int, 2> strengths) {
  const double radius_px = 2.2 * static_cast<double>(candidate.radius_px) + 1.5;
  const auto& at = candidate.at;
  const int top = std::max(0, static_cast<int>(std::ceil(at.v_px - radius_px)));
  const int bottom = std::min(picture.size.height_px - 1, static_cast<int>(std::floor(at.v_px + radius_px)));
  Flank flank;
  for (int v = top; v <= bottom; ++v) {
    const double half_px = std::sqrt(std::max(0.0, radius_px * radius_px - (v - at.v_px) * (v - at.v_px)));
    const int left = std::max(0, static_cast<int>(std::ceil(at.u_px - half_px)) + 1) / 2;
    const int right = std::min(picture.size.width_px - 1, static_cast<int>(std::floor(at.u_px + half_px))) / 2;
    const int row = chroma_row(picture, v);
    for (int pair = left; pair <= right; ++pair) {
      const int red = picture.v.at(pair, row);
      const int strength = 3 * picture.luma.at(2 * pair, v) + 4 * red;
      if (strength < strengths[0] || strength > strengths[1]) continue;
      flank.blue += picture.u.at(pair, row);
      flank.red += red;
      ++flank.pixels;
    }
  }
  return flank;
}

}  // namespace

SceneLight scene_light_of(const Picture& picture) {
  constexpr int kStep = 32;
  constexpr double kWhiteShare = 0.95;
  Levels levels;
  long sum = 0;
  long count = 0;
  for (int v = kStep / 2; v < picture.size.height_px; v += kStep) {
    for (int u = kStep / 2; u < picture.size.width_px; u += kStep) {
      levels.add(picture.luma.at(u, v));
      sum += picture.luma.at(u, v);
      ++count;
    }
  }
  if (count == 0) return {};
  return {static_cast<double>(sum) / static_cast<double>(count), levels.at(kWhiteShare)};
}

int strength_of_red_surface(const SceneLight& light) {
  constexpr int kOfNoRed = 4 * 128;
  constexpr int kOfLuma = 3;
  return kOfNoRed + kOfLuma * light.white_luma;
}

double hue_of_flank(const Picture& picture, const Candidate& candidate) {
  constexpr int kClips = 1100;  // S: above it red may clip, and a red LED turns orange
  const float ground = candidate.peak - candidate.contrast;
  const int low = static_cast<int>(ground + 0.12F * candidate.contrast);
  const int high = std::min(static_cast<int>(ground + 0.85F * candidate.contrast), kClips);
  const Flank flank = flank_of(picture, candidate, {low, high});
  const int red = flank.red - flank.pixels * static_cast<int>(candidate.surround_red);
  const int blue = flank.blue - flank.pixels * blue_around(picture, candidate);
  return red > 0 ? -static_cast<double>(blue) / red : 0.0;
}

}  // namespace tripoint
