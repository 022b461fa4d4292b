// One JPEG on its way through libjpeg. C-like on purpose: libjpeg leaves by longjmp, so nothing in here owns anything.
#pragma once

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>  // jpeglib.h needs FILE

#include <jpeglib.h>

#include <span>
#include <string_view>

namespace tripoint {

/// Where one component's rows go; `data` holds `stride_bytes` x all rows of the component, padding included.
struct JpegTarget {
  std::uint8_t* data = nullptr;
  std::size_t stride_bytes = 0;
};

/// Made anew for each picture, so that no table of an earlier, perhaps damaged picture can serve the next one.
/// libjpeg-turbo supplies the standard Huffman tables when the data has none, as in most webcams' MJPEG.
/// Every warning about the data, but for a little padding, ends the decoding, because libjpeg's remedy is to fill the
/// rest with grey.
class JpegSession {
 public:
  /// @param jpeg borrowed until the session ends
  explicit JpegSession(std::span<const std::uint8_t> jpeg);
  JpegSession(const JpegSession&) = delete;
  JpegSession& operator=(const JpegSession&) = delete;
  ~JpegSession();

  /// @return false when the header is damaged; `error` says how
  [[nodiscard]] bool read_header();
  /// Decodes every component as it is stored: no upsampling, no colour conversion. To be called once. Of rows that are
  /// not chosen the inverse DCT is saved and the target left as it was; damage is found in them all the same.
  ///
  /// @param chosen one for each row of MCUs
  /// @return false when the data is damaged; `error` says how and the targets hold nothing of worth
  [[nodiscard]] bool read_planes(const std::array<JpegTarget, 3>& targets, std::span<const bool> chosen);

  /// From the first scan to the end marker: all that says what the picture shows, but for its tables. Empty before
  /// `read_planes`.
  [[nodiscard]] std::span<const std::uint8_t> scans() const { return scans_; }

  [[nodiscard]] const jpeg_decompress_struct& header() const { return codec_; }
  [[nodiscard]] std::string_view error() const { return message_.data(); }

 private:
  [[noreturn]] static void leave(j_common_ptr codec);
  static void take_message(j_common_ptr codec, int level);
  static void check_scans(j_common_ptr codec);
  void prepare();

  std::span<const std::uint8_t> jpeg_;
  std::span<const std::uint8_t> scans_;
  jpeg_decompress_struct codec_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  std::jmp_buf escape_{};
  std::array<char, JMSG_LENGTH_MAX> message_{};
};

}  // namespace tripoint
