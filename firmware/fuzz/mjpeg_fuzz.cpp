// Any bytes as a camera's MJPEG frame: refused or whole, and every value of a whole picture can be read. A band of rows
// is refused when the whole is, and shows the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>

#include "capture/mjpeg_decoder.h"

namespace {

// Small enough that a few bytes which claim a large picture do not spend the run on clearing memory.
constexpr int kLargestSide_px = 512;

std::uint64_t sum_of(const tripoint::Picture& picture) {
  std::uint64_t sum = 0;
  for (int y = 0; y < picture.size.height_px; ++y) {
    const int chroma_y = picture.chroma_rows_halved ? y / 2 : y;
    for (int x = 0; x < picture.size.width_px; ++x) {
      sum += picture.luma.at(x, y);
      if (picture.u.data != nullptr)
        sum += picture.u.at(x / 2, chroma_y) + std::uint64_t{picture.v.at(x / 2, chroma_y)};
    }
  }
  return sum;
}

/// Nothing is compared where a picture has no chroma.
bool same_row(const tripoint::Picture& part, const tripoint::Picture& whole, int y) {
  const int chroma_y = part.chroma_rows_halved ? y / 2 : y;
  for (int x = 0; x < part.size.width_px; ++x) {
    if (part.luma.at(x, y) != whole.luma.at(x, y)) return false;
    if (part.v.data != nullptr && part.v.at(x / 2, chroma_y) != whole.v.at(x / 2, chroma_y)) return false;
  }
  return true;
}

/// The rows in the middle against those of the whole picture.
void check_band(std::span<const std::uint8_t> jpeg, tripoint::ImageSize size, const tripoint::Picture* whole) {
  static tripoint::MjpegDecoder decoder;
  tripoint::RowBands middle;
  middle.push_back({size.height_px / 3, size.height_px / 2 + 1});
  const auto part = decoder.decode(jpeg, size, middle);
  if (part.has_value() != (whole != nullptr)) std::abort();
  if (!part) return;
  if (part->bands.size() > 1) std::abort();
  for (const tripoint::RowBand& band : part->bands) {
    for (int y = band.top_px; y < band.bottom_px; ++y) {
      if (!same_row(*part, *whole, y)) std::abort();
    }
  }
}

std::uint64_t largest_sum(tripoint::ImageSize size) {
  return std::uint64_t{3} * 255 * static_cast<std::uint64_t>(size.width_px) *
         static_cast<std::uint64_t>(size.height_px);
}

/// The size that the first frame header (SOF0 to SOF2) claims, or nothing.
std::optional<tripoint::ImageSize> claimed_size(std::span<const std::uint8_t> jpeg) {
  for (std::size_t i = 0; i + 9 < jpeg.size(); ++i) {
    if (jpeg[i] != 0xFF || jpeg[i + 1] < 0xC0 || jpeg[i + 1] > 0xC2) continue;
    return tripoint::ImageSize{jpeg[i + 7] * 256 + jpeg[i + 8], jpeg[i + 5] * 256 + jpeg[i + 6]};
  }
  return std::nullopt;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static tripoint::MjpegDecoder decoder;
  const std::span<const std::uint8_t> jpeg(data, size);
  const std::optional<tripoint::ImageSize> claimed = claimed_size(jpeg);
  if (!claimed || claimed->width_px > kLargestSide_px || claimed->height_px > kLargestSide_px) {
    static_cast<void>(decoder.decode(jpeg, tripoint::ImageSize{64, 48}));
    return 0;
  }
  const auto picture = decoder.decode(jpeg, std::nullopt);
  if (picture && sum_of(*picture) > largest_sum(picture->size)) std::abort();
  if (picture) check_band(jpeg, picture->size, &*picture);
  if (!picture) check_band(jpeg, *claimed, nullptr);
  return 0;
}
