#include "explain/rgb_image.h"

#include <algorithm>
#include <cmath>

namespace tripoint {
namespace {

RgbImage black_image(ImageSize size) {
  const auto pixels = static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px);
  return {size, std::vector<std::uint8_t>(3 * pixels)};
}

std::uint8_t level(int thousandths) {
  return static_cast<std::uint8_t>(std::clamp((thousandths + 500) / 1000, 0, 255));
}

Colour colour_of(int luma, int u, int v) {
  const int blue_step = u - 128;
  const int red_step = v - 128;
  return {level(1000 * luma + 1402 * red_step), level(1000 * luma - 344 * blue_step - 714 * red_step),
          level(1000 * luma + 1772 * blue_step)};
}

/// Mean of a square of pixels.
Colour mean_of(const RgbImage& image, int left, int top, int side) {
  int red = 0;
  int green = 0;
  int blue = 0;
  for (int y = top; y < top + side; ++y) {
    for (int x = left; x < left + side; ++x) {
      const Colour colour = image.at(x, y);
      red += colour.red;
      green += colour.green;
      blue += colour.blue;
    }
  }
  const int pixels = side * side;
  return {static_cast<std::uint8_t>(red / pixels), static_cast<std::uint8_t>(green / pixels),
          static_cast<std::uint8_t>(blue / pixels)};
}

}  // namespace

RgbImage plain_image(ImageSize size, Colour colour) {
  RgbImage image = black_image(size);
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    image.values[i] = colour.red;
    image.values[i + 1] = colour.green;
    image.values[i + 2] = colour.blue;
  }
  return image;
}

RgbImage rgb_of(const Picture& picture) {
  RgbImage image = black_image(picture.size);
  const bool grey = picture.u.data == nullptr || picture.v.data == nullptr;
  for (int y = 0; y < picture.size.height_px; ++y) {
    const int chroma_y = picture.chroma_rows_halved ? y / 2 : y;
    for (int x = 0; x < picture.size.width_px; ++x) {
      const std::uint8_t luma = picture.luma.at(x, y);
      image.set(x, y,
                grey ? Colour{luma, luma, luma}
                     : colour_of(luma, picture.u.at(x / 2, chroma_y), picture.v.at(x / 2, chroma_y)));
    }
  }
  return image;
}

RgbImage reduced(const RgbImage& image, int divisor) {
  RgbImage out = black_image({image.size.width_px / divisor, image.size.height_px / divisor});
  for (int y = 0; y < out.size.height_px; ++y) {
    for (int x = 0; x < out.size.width_px; ++x) out.set(x, y, mean_of(image, x * divisor, y * divisor, divisor));
  }
  return out;
}

RgbImage enlarged(const RgbImage& image, int factor) {
  RgbImage out = black_image({image.size.width_px * factor, image.size.height_px * factor});
  for (int y = 0; y < out.size.height_px; ++y) {
    for (int x = 0; x < out.size.width_px; ++x) out.set(x, y, image.at(x / factor, y / factor));
  }
  return out;
}

RgbImage brightened(RgbImage image) {
  for (std::uint8_t& value : image.values) {
    value = static_cast<std::uint8_t>(std::lround(std::sqrt(255.0 * value)));
  }
  return image;
}

RgbImage cut_out(const RgbImage& image, PixelPlace center, int side_px, Colour outside) {
  RgbImage out = plain_image({side_px, side_px}, outside);
  const int left = center.u_px - side_px / 2;
  const int top = center.v_px - side_px / 2;
  for (int y = std::max(0, -top); y < std::min(side_px, image.size.height_px - top); ++y) {
    for (int x = std::max(0, -left); x < std::min(side_px, image.size.width_px - left); ++x) {
      out.set(x, y, image.at(left + x, top + y));
    }
  }
  return out;
}

}  // namespace tripoint
