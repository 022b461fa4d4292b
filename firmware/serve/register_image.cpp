#include "serve/register_image.h"

namespace tripoint {
namespace {

constexpr std::array<std::uint16_t, RegisterImage::kSize> mirror_order() {
  std::array<std::uint16_t, RegisterImage::kSize> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint16_t>(i);
  for (const registers::Row& row : registers::kTable) {
    for (std::uint16_t word = 0; word < row.words; ++word) {
      order[row.address + word] = static_cast<std::uint16_t>(row.address + row.words - 1 - word);
    }
  }
  return order;
}

}  // namespace

constexpr std::array<std::uint16_t, RegisterImage::kSize> kMirrorOrder = mirror_order();

}  // namespace tripoint
