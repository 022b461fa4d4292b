// A coloured image in memory, and what is done to a camera's picture before something is drawn on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "line/detect/candidate.h"
#include "ports/frame.h"
#include "values/pixel.h"

namespace tripoint {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Rows of red, green, blue without padding.
struct RgbImage {
  ImageSize size;
  std::vector<std::uint8_t> values;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width_px) + static_cast<std::size_t>(x));
  }
  [[nodiscard]] Colour at(int x, int y) const {
    const std::uint8_t* value = values.data() + index(x, y);
    return {value[0], value[1], value[2]};
  }
  void set(int x, int y, Colour colour) {
    std::uint8_t* value = values.data() + index(x, y);
    value[0] = colour.red;
    value[1] = colour.green;
    value[2] = colour.blue;
  }
};

RgbImage plain_image(ImageSize size, Colour colour);

/// Grey without chroma. Source of the conversion: ITU-R BT.601, full range as in JFIF 1.02.
RgbImage rgb_of(const Picture& picture);

/// Means of divisor x divisor pixels; what is left over at the right and at the bottom is cut off.
RgbImage reduced(const RgbImage& image, int divisor);

/// Every pixel as factor x factor equal ones: people shall see the pixels that the detector saw.
RgbImage enlarged(const RgbImage& image, int factor);

/// With gamma 2, for dark pictures: a twentieth of full scale becomes a quarter.
RgbImage brightened(RgbImage image);

/// A square around a pixel; what lies outside of the image has the colour `outside`.
RgbImage cut_out(const RgbImage& image, PixelPlace center, int side_px, Colour outside);

}  // namespace tripoint
