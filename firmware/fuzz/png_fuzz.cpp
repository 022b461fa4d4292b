// Any bytes as a PNG picture, as they are and with the sums of their chunks made right: else no changed byte would get
// past those. Refused or whole; a whole picture has the size that its header claims, and every value can be read.
#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "capture/mjpeg_decoder.h"
#include "capture/png_decoder.h"

namespace {

// Small enough that a few bytes which claim a large picture do not spend the run on clearing memory.
constexpr std::uint32_t kLargestSide_px = 512;
constexpr std::uint32_t kDecodersLimit_px = tripoint::kMaxPictureSide_px;

// PNG (ISO/IEC 15948:2004): a signature, then chunks of length, type, data and CRC.
constexpr std::size_t kSignature_bytes = 8;
constexpr std::size_t kWord_bytes = 4;
constexpr std::size_t kAroundData_bytes = 3 * kWord_bytes;
constexpr std::uint32_t kHeaderType = 0x49484452;  // "IHDR"

struct ClaimedSize {
  std::uint32_t width_px, height_px;
  [[nodiscard]] std::uint32_t larger_px() const { return std::max(width_px, height_px); }
};

std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < kWord_bytes; ++i) word = word << 8U | bytes[at + i];
  return word;
}

/// Where each whole chunk begins.
std::vector<std::size_t> chunks_of(std::span<const std::uint8_t> png) {
  std::vector<std::size_t> found;
  std::size_t at = kSignature_bytes;
  while (at + kAroundData_bytes <= png.size() && word_at(png, at) <= png.size() - at - kAroundData_bytes) {
    found.push_back(at);
    at += kAroundData_bytes + word_at(png, at);
  }
  return found;
}

std::vector<std::uint8_t> with_right_sums(std::span<const std::uint8_t> png) {
  std::vector<std::uint8_t> right(png.begin(), png.end());
  for (const std::size_t at : chunks_of(png)) {
    const std::size_t summed_bytes = kWord_bytes + word_at(png, at);  // type and data
    const auto sum = crc32(0, png.data() + at + kWord_bytes, static_cast<uInt>(summed_bytes));
    for (std::size_t i = 0; i < kWord_bytes; ++i) {
      right[at + kWord_bytes + summed_bytes + i] = static_cast<std::uint8_t>(sum >> (24U - 8U * i));
    }
  }
  return right;
}

/// What the first header claims, or nothing.
std::optional<ClaimedSize> claimed_size(std::span<const std::uint8_t> png) {
  for (const std::size_t at : chunks_of(png)) {
    if (word_at(png, at + kWord_bytes) != kHeaderType || word_at(png, at) < 2 * kWord_bytes) continue;
    return ClaimedSize{word_at(png, at + 2 * kWord_bytes), word_at(png, at + 3 * kWord_bytes)};
  }
  return std::nullopt;
}

/// An odd row of YUYV ends in the last pixel twice.
bool last_pixels_are_equal(const tripoint::PackedPicture& picture) {
  const auto height = static_cast<std::size_t>(picture.size.height_px);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* end = picture.data.data() + (y + 1) * picture.stride_bytes;
    if (end[-4] != end[-2]) return false;
  }
  return true;
}

void check(const tripoint::PackedPicture& picture, const ClaimedSize& claimed) {
  const bool grey = picture.format == tripoint::PixelFormat::kGrey;
  const std::size_t width = claimed.width_px;
  if (static_cast<std::size_t>(picture.size.width_px) != width) std::abort();
  if (static_cast<std::uint32_t>(picture.size.height_px) != claimed.height_px) std::abort();
  if (picture.stride_bytes != (grey ? width : (width + 1) / 2 * 4)) std::abort();
  if (picture.data.size() != picture.stride_bytes * claimed.height_px) std::abort();
  if (!grey && width % 2 == 1 && !last_pixels_are_equal(picture)) std::abort();
}

void decode(std::span<const std::uint8_t> png) {
  const std::optional<ClaimedSize> claimed = claimed_size(png);
  const bool too_large = claimed && claimed->larger_px() > kDecodersLimit_px;
  if (claimed && !too_large && claimed->larger_px() > kLargestSide_px) return;
  const auto picture = tripoint::picture_from_png(png);
  if (!picture) return;
  if (!claimed || too_large) std::abort();
  check(*picture, *claimed);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> png(data, size);
  decode(png);
  decode(with_right_sums(png));
  return 0;
}
