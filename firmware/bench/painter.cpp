#include "bench/painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tripoint::bench {
namespace {

/// Mean over a pixel of a Gaussian of height 1, along one axis.
double integrated(int pixel, double center, double sigma_px) {
  const double q = 1.0 / (sigma_px * std::numbers::sqrt2);
  return sigma_px * std::sqrt(std::numbers::pi / 2.0) *
         (std::erf((pixel + 0.5 - center) * q) - std::erf((pixel - 0.5 - center) * q));
}

std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

double luma_of(const Color& c) { return 16.0 + 0.257 * c[0] + 0.504 * c[1] + 0.098 * c[2]; }
double u_of(const Color& c) { return 128.0 - 0.148 * c[0] - 0.291 * c[1] + 0.439 * c[2]; }
double v_of(const Color& c) { return 128.0 + 0.439 * c[0] - 0.368 * c[1] - 0.071 * c[2]; }

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

RawPixel anywhere(ImageSize size, std::mt19937& random) {
  return {uniform(random, 0.0, size.width_px), uniform(random, 0.0, size.height_px)};
}

void add_leds(Painting& painting, ImageSize size, std::mt19937& random) {
  for (int k = 0; k < 3; ++k) {
    painting.add(Light{.at = {size.width_px * (0.2 + 0.3 * k + uniform(random, -0.05, 0.05)),
                              size.height_px * uniform(random, 0.3, 0.7)},
                       .sigma_px = uniform(random, 1.5, 2.2),
                       .peak = uniform(random, 1.0, 3.0)});
  }
}

}  // namespace

Picture YuyvPicture::view() const {
  return picture_of({.format = PixelFormat::kYuyv,
                     .size = size,
                     .stride_bytes = static_cast<std::size_t>(size.width_px) * 2,
                     .data = bytes});
}

Picture PlanarPicture::view() const {
  const auto width = static_cast<std::size_t>(size.width_px);
  return {.size = size,
          .luma = {luma.data(), width, 1},
          .u = {u.data(), width / 2, 1},
          .v = {v.data(), width / 2, 1},
          .chroma_rows_halved = chroma_rows_halved,
          .interleaved_yuyv = false};
}

PlanarPicture planes_of(const YuyvPicture& picture, bool halve_chroma_rows) {
  const Picture from = picture.view();
  PlanarPicture planes{.size = picture.size, .chroma_rows_halved = halve_chroma_rows, .luma = {}, .u = {}, .v = {}};
  for (int v = 0; v < picture.size.height_px; ++v) {
    for (int u = 0; u < picture.size.width_px; ++u) planes.luma.push_back(from.luma.at(u, v));
  }
  const int step = halve_chroma_rows ? 2 : 1;
  for (int v = 0; v < picture.size.height_px; v += step) {
    for (int u = 0; u < picture.size.width_px / 2; ++u) {
      planes.u.push_back(static_cast<std::uint8_t>((from.u.at(u, v) + from.u.at(u, v + step - 1)) / 2));
      planes.v.push_back(static_cast<std::uint8_t>((from.v.at(u, v) + from.v.at(u, v + step - 1)) / 2));
    }
  }
  return planes;
}

Painting::Painting(ImageSize size, double ground)
    : size_(size),
      pixels_(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px),
              Color{ground, ground, ground}) {}

std::size_t Painting::index(int u, int v) const {
  return static_cast<std::size_t>(v) * static_cast<std::size_t>(size_.width_px) + static_cast<std::size_t>(u);
}

void Painting::add(const Ellipse& ellipse) {
  const auto [center_u, center_v] = ellipse.at;
  const int left = std::max(0, static_cast<int>(center_u - ellipse.half_width_px));
  const int right = std::min(size_.width_px - 1, static_cast<int>(center_u + ellipse.half_width_px) + 1);
  const int top = std::max(0, static_cast<int>(center_v - ellipse.half_height_px));
  const int bottom = std::min(size_.height_px - 1, static_cast<int>(center_v + ellipse.half_height_px) + 1);
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      const double x = (u - center_u) / ellipse.half_width_px;
      const double y = (v - center_v) / ellipse.half_height_px;
      if (x * x + y * y <= 1.0) pixels_[index(u, v)] = ellipse.color;
    }
  }
}

void Painting::add(const Light& light) {
  constexpr double kHaloWidths = 3.0;
  const int reach = static_cast<int>(std::ceil(4.0 * kHaloWidths * light.sigma_px));
  const auto center_u = static_cast<int>(std::lround(light.at.u_px));
  const auto center_v = static_cast<int>(std::lround(light.at.v_px));
  for (int v = std::max(0, center_v - reach); v <= std::min(size_.height_px - 1, center_v + reach); ++v) {
    for (int u = std::max(0, center_u - reach); u <= std::min(size_.width_px - 1, center_u + reach); ++u) {
      const double core = integrated(u, light.at.u_px, light.sigma_px) * integrated(v, light.at.v_px, light.sigma_px);
      const double wide = kHaloWidths * light.sigma_px;
      const double halo = integrated(u, light.at.u_px, wide) * integrated(v, light.at.v_px, wide);
      Color& pixel = pixels_[index(u, v)];
      for (std::size_t c = 0; c < 3; ++c) pixel[c] += light.color[c] * light.peak * (core + light.halo * halo);
    }
  }
}

YuyvPicture Painting::develop(const Development& development, std::mt19937& random) const {
  std::normal_distribution<double> noise(0.0, development.noise);
  const auto tone = [&](double linear) {
    const double value = std::clamp(std::min(linear, 1.3) + noise(random), 0.0, 1.0);
    return 255.0 * (development.gamma ? std::pow(value, 1.0 / 2.2) : value);
  };
  YuyvPicture picture{.size = size_, .bytes = {}};
  picture.bytes.reserve(pixels_.size() * 2);
  for (std::size_t i = 0; i + 1 < pixels_.size(); i += 2) {
    std::array<Color, 2> pair{};
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t c = 0; c < 3; ++c) pair[k][c] = tone(pixels_[i + k][c]);
    }
    picture.bytes.push_back(byte_of(luma_of(pair[0])));
    picture.bytes.push_back(byte_of(0.5 * (u_of(pair[0]) + u_of(pair[1]))));
    picture.bytes.push_back(byte_of(luma_of(pair[1])));
    picture.bytes.push_back(byte_of(0.5 * (v_of(pair[0]) + v_of(pair[1]))));
  }
  return picture;
}

YuyvPicture clean_scene(ImageSize size, std::uint32_t seed) {
  std::mt19937 random(seed);
  Painting painting(size, 0.02);
  add_leds(painting, size, random);
  return painting.develop({}, random);
}

YuyvPicture dark_clutter(ImageSize size, std::uint32_t seed) {
  constexpr double kWhiteLevel = 0.06;
  constexpr std::array<Color, 8> kPalette{{{0.60, 0.27, 0.16},    // skin
                                           {0.45, 0.20, 0.12},    // skin in the shade
                                           {0.70, 0.22, 0.02},    // orange
                                           {0.45, 0.03, 0.03},    // red paint
                                           {0.20, 0.02, 0.02},    // dark red
                                           {0.75, 0.05, 0.04},    // red plastic
                                           {0.80, 0.80, 0.78},    // white
                                           {0.10, 0.20, 0.50}}};  // blue
  constexpr std::array<Color, 3> kReflections{{{1.0, 1.0, 1.0}, {1.0, 0.75, 0.45}, {1.0, 0.55, 0.2}}};
  std::mt19937 random(seed);
  Painting painting(size, 0.3 * kWhiteLevel);
  const double scale = size.width_px / 640.0;
  for (std::size_t k = 0; k < 64; ++k) {
    Color color = kPalette[k % kPalette.size()];
    for (double& channel : color) channel *= kWhiteLevel * uniform(random, 0.6, 1.1);
    const double half = k % 2 == 0 ? uniform(random, 3.0, 15.0) : uniform(random, 20.0, 90.0);
    painting.add(Ellipse{anywhere(size, random), half * scale, half * scale * uniform(random, 0.3, 1.2), color});
  }
  for (std::size_t k = 0; k < 18; ++k) {
    painting.add(Light{.at = anywhere(size, random),
                       .sigma_px = uniform(random, 0.8, 3.0),
                       .peak = kWhiteLevel * std::exp(uniform(random, 0.0, 4.0)),
                       .color = kReflections[k % kReflections.size()]});
  }
  add_leds(painting, size, random);
  return painting.develop({}, random);
}

}  // namespace tripoint::bench
