#include "capture/png_decoder.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "capture/mjpeg_decoder.h"

namespace tripoint {
namespace {

/// libpng's simplified reader: it keeps its own jumps inside.
class PngReader {
 public:
  explicit PngReader(std::span<const std::uint8_t> png) {
    image_.version = PNG_IMAGE_VERSION;
    // NOLINTNEXTLINE(cppcoreguidelines-prefer-member-initializer): the version must be set first
    opened_ = png_image_begin_read_from_memory(&image_, png.data(), png.size()) != 0;
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_image_free(&image_); }

  [[nodiscard]] bool opened() const { return opened_; }
  [[nodiscard]] bool colour() const { return (image_.format & PNG_FORMAT_FLAG_COLOR) != 0; }
  [[nodiscard]] std::size_t width() const { return image_.width; }
  [[nodiscard]] std::size_t height() const { return image_.height; }
  [[nodiscard]] std::string_view error() const { return image_.message; }

  /// @return rows of RGB or grey without padding; empty when damaged
  std::vector<std::uint8_t> pixels() {
    image_.format = colour() ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    std::vector<std::uint8_t> values(PNG_IMAGE_SIZE(image_));
    const auto row_values = static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image_));
    if (png_image_finish_read(&image_, nullptr, values.data(), row_values, nullptr) == 0) return {};
    return values;
  }

 private:
  png_image image_{};
  bool opened_ = false;
};

tl::unexpected<Error> corrupt(std::string_view why) {
  return failure(ErrorCode::kCorruptFrame, fmt::format("PNG not usable: {}", why));
}

std::uint8_t level(int thousandths) {
  return static_cast<std::uint8_t>(std::clamp((thousandths + 500) / 1000, 0, 255));
}

std::uint8_t luma(const std::uint8_t* rgb) { return level(299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2]); }

/// Two neighbours in a row; `a` and `b` may be the same pixel.
void pack_pair(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* yuyv) {
  const int red = a[0] + b[0];
  const int green = a[1] + b[1];
  const int blue = a[2] + b[2];
  yuyv[0] = luma(a);
  yuyv[1] = level(128'000 + (-169 * red - 331 * green + 500 * blue) / 2);
  yuyv[2] = luma(b);
  yuyv[3] = level(128'000 + (500 * red - 419 * green - 81 * blue) / 2);
}

PackedPicture packed_colour(std::span<const std::uint8_t> rgb, std::size_t width, std::size_t height) {
  PackedPicture picture;
  picture.format = PixelFormat::kYuyv;
  picture.stride_bytes = (width + 1) / 2 * 4;
  picture.data.resize(picture.stride_bytes * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* row = rgb.data() + y * width * 3;
    for (std::size_t x = 0; x < width; x += 2) {
      const std::size_t next = std::min(x + 1, width - 1);
      pack_pair(row + 3 * x, row + 3 * next, picture.data.data() + y * picture.stride_bytes + 2 * x);
    }
  }
  return picture;
}

}  // namespace

Result<PackedPicture> picture_from_png(std::span<const std::uint8_t> png) {
  PngReader reader(png);
  if (!reader.opened()) return corrupt(reader.error());
  constexpr auto kMaxSide = static_cast<std::size_t>(kMaxPictureSide_px);
  if (reader.width() > kMaxSide || reader.height() > kMaxSide) return corrupt("larger than 4096x4096");
  std::vector<std::uint8_t> pixels = reader.pixels();
  if (pixels.empty()) return corrupt(reader.error());

  PackedPicture picture;
  if (reader.colour()) {
    picture = packed_colour(pixels, reader.width(), reader.height());
  } else {
    picture.stride_bytes = reader.width();
    picture.data = std::move(pixels);
  }
  picture.size = {static_cast<int>(reader.width()), static_cast<int>(reader.height())};
  return picture;
}

}  // namespace tripoint
