#include "capture/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>

#include "capture/png_decoder.h"

namespace tripoint {
namespace {

bool is_png(std::span<const std::uint8_t> data) {
  constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return data.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), data.begin());
}

tl::unexpected<Error> about(const std::filesystem::path& path, const Error& error) {
  return failure(error.code, fmt::format("{}: {}", path.string(), error.message));
}

}  // namespace

Result<std::vector<std::uint8_t>> bytes_of_file(const std::filesystem::path& path, std::uintmax_t limit_bytes) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failure(ErrorCode::kCannotRead, fmt::format("{}: {}", path.string(), error.message()));
  if (size > limit_bytes) {
    return failure(ErrorCode::kCannotRead, fmt::format("{}: {} bytes, at most {}", path.string(), size, limit_bytes));
  }
  std::vector<std::uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) return failure(ErrorCode::kCannotRead, fmt::format("{}: cannot be read", path.string()));
  return bytes;
}

Result<LoadedImage> LoadedImage::load(const std::filesystem::path& path) {
  const Result<std::vector<std::uint8_t>> bytes = bytes_of_file(path, kMaxImageFile_bytes);
  if (!bytes) return tl::make_unexpected(bytes.error());
  LoadedImage image;
  if (is_png(*bytes)) {
    Result<PackedPicture> png = picture_from_png(*bytes);
    if (!png) return about(path, png.error());
    image.packed_ = std::move(png->data);
    image.picture_ = picture_of(
        {.format = png->format, .size = png->size, .stride_bytes = png->stride_bytes, .data = image.packed_});
    return image;
  }
  const Result<Picture> jpeg = image.jpeg_.decode(*bytes, std::nullopt);
  if (!jpeg) return about(path, jpeg.error());
  image.picture_ = *jpeg;
  return image;
}

}  // namespace tripoint
