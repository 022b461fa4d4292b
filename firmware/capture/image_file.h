// A picture file as the same planes that a camera's frame gives, for detection offline.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "capture/mjpeg_decoder.h"
#include "ports/frame.h"
#include "values/result.h"

namespace tripoint {

inline constexpr std::uintmax_t kMaxImageFile_bytes = std::uintmax_t{64} << 20U;

/// Reads a whole file of at most `limit_bytes`.
///
/// @return kCannotRead when it is missing, not readable or larger; the message names it
Result<std::vector<std::uint8_t>> bytes_of_file(const std::filesystem::path& path, std::uintmax_t limit_bytes);

/// Owns the pixels that its picture looks at; moving it keeps the picture valid.
class LoadedImage {
 public:
  /// Loads a JPEG or PNG, told apart by their first bytes.
  ///
  /// @return kCannotRead as bytes_of_file; kCorruptFrame when neither decodes; messages name the file
  static Result<LoadedImage> load(const std::filesystem::path& path);

  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  LoadedImage() = default;

  MjpegDecoder jpeg_;
  std::vector<std::uint8_t> packed_;
  Picture picture_;
};

}  // namespace tripoint
