#include <apriltag/apriltag.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "tags/libapriltag_families.h"
#include "tags/tag_print.h"

namespace tripoint {
namespace {

using OwnedFamily = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)>;

constexpr int kMiddle = 127;  // the library's picture is black and white

/// Versions of the library differ in the type of the index.
template <typename Index>
image_u8_t* pictured(image_u8_t* (*make)(apriltag_family_t*, Index), apriltag_family_t* family, int id) {
  return make(family, static_cast<Index>(id));
}

void end(image_u8_t* picture) {
  std::free(picture->buf);  // NOLINT(cppcoreguidelines-no-malloc): the library's own way is in another library
  std::free(picture);       // NOLINT(cppcoreguidelines-no-malloc)
}

/// The picture that the library would print, a pixel a cell.
TagCells cells_of(apriltag_family_t* family, int id) {
  const std::unique_ptr<image_u8_t, void (*)(image_u8_t*)> picture(pictured(apriltag_to_image, family, id), end);
  TagCells cells;
  cells.across = family->width_at_border;
  cells.total = picture->width;
  for (int y = 0; y < picture->height; ++y) {
    for (int x = 0; x < picture->width; ++x) cells.light.push_back(picture->buf[y * picture->stride + x] > kMiddle);
  }
  cells.read.resize(cells.light.size());
  const int before = (cells.total - cells.across) / 2;  // the family counts from the square with the corners
  for (std::uint32_t bit = 0; bit < family->nbits; ++bit) {
    const int row = static_cast<int>(family->bit_y[bit]) + before;
    const int column = static_cast<int>(family->bit_x[bit]) + before;
    const int cell = row * cells.total + column;
    cells.read[static_cast<std::size_t>(cell)] = true;
  }
  return cells;
}

}  // namespace

Result<TagCells> tag_print(std::string_view family, int id) {
  return family_named(family).and_then([&](const NamedFamily& named) -> Result<TagCells> {
    const OwnedFamily made(named.create(), named.destroy);
    if (id < 0 || static_cast<std::uint32_t>(id) >= made->ncodes) {
      return failure(ErrorCode::kOutOfRange, std::string(named.name) + " has no tag " + std::to_string(id) +
                                                 ": permitted is 0 to " + std::to_string(made->ncodes - 1));
    }
    return cells_of(made.get(), id);
  });
}

}  // namespace tripoint
