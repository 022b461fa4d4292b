// Small pictures with known truth for tests and benchmarks: ellipses and pixel-integrated lights in linear light.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "ports/frame.h"
#include "values/pixel.h"

namespace tripoint::bench {

using Color = std::array<double, 3>;  ///< red, green, blue
inline constexpr Color kRedLed{1.0, 0.06, 0.03};
inline constexpr Color kWhite{1.0, 1.0, 1.0};

/// A Gaussian core with a wide halo of a hundredth of its peak; levels in units of sensor clip.
struct Light {
  RawPixel at;
  double sigma_px = 1.8;
  double peak = 2.0;
  Color color = kRedLed;
  double halo = 0.01;
};

struct Ellipse {
  RawPixel at;
  double half_width_px = 10.0;
  double half_height_px = 10.0;
  Color color = kWhite;
};

/// A YUYV buffer that knows its size.
struct YuyvPicture {
  ImageSize size;
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] Picture view() const;
};

/// The same picture as three planes; chroma rows averaged when halved.
struct PlanarPicture {
  ImageSize size;
  bool chroma_rows_halved = false;
  std::vector<std::uint8_t> luma, u, v;

  [[nodiscard]] Picture view() const;
};
PlanarPicture planes_of(const YuyvPicture& picture, bool halve_chroma_rows);

struct Development {
  double noise = 0.002;  ///< standard deviation per channel in units of clip, before the tone curve
  bool gamma = true;     ///< v^(1/2.2), else linear
};

class Painting {
 public:
  Painting(ImageSize size, double ground);

  void add(const Ellipse& ellipse);
  void add(const Light& light);
  /// Clips, adds noise, applies the tone curve and codes as BT.601 limited range, chroma averaged over two pixels.
  [[nodiscard]] YuyvPicture develop(const Development& development, std::mt19937& random) const;

 private:
  [[nodiscard]] std::size_t index(int u, int v) const;

  ImageSize size_;
  std::vector<Color> pixels_;
};

/// Three LEDs well apart on a dark ground.
YuyvPicture clean_scene(ImageSize size, std::uint32_t seed);
/// The same LEDs among red, orange, skin-coloured and white things lit to 6 % of clip, reflections and lamps.
YuyvPicture dark_clutter(ImageSize size, std::uint32_t seed);

}  // namespace tripoint::bench
