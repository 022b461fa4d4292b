#include "explain/png_encoder.h"

#include <fmt/format.h>
#include <png.h>

#include "values/assert.h"

namespace tripoint {
namespace {

tl::unexpected<Error> refused(png_image& image) {
  const std::string why = image.message;
  png_image_free(&image);
  return failure(ErrorCode::kCannotWrite, fmt::format("PNG cannot be made: {}", why));
}

}  // namespace

Result<std::string> png_of(const RgbImage& image) {
  TRIPOINT_ASSERT(image.size.width_px > 0 && image.size.height_px > 0);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.size.width_px);
  png.height = static_cast<png_uint_32>(image.size.height_px);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t most_bytes = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(most_bytes, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &most_bytes, 0, image.values.data(), 0, nullptr) == 0) {
    return refused(png);
  }
  bytes.resize(most_bytes);
  return bytes;
}

}  // namespace tripoint
