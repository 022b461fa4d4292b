// Small recordings made on disk for a test, and taken away afterwards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scratch_folder.h"

#include "values/result.h"

namespace tripoint::test {

inline constexpr int kWidth_px = 16;
inline constexpr int kHeight_px = 16;
inline constexpr std::size_t kYuyv_bytes = std::size_t{2} * kWidth_px * kHeight_px;

class RecordingFolder {
 public:
  RecordingFolder();

  void write(const std::filesystem::path& name, std::string_view text) const;
  void describe(std::string_view pixel_format) const;
  /// A yuyv picture with this value in every byte.
  void picture(std::string_view side, int index, char value) const;
  /// frames.csv with its header.
  void rows(std::string_view text) const {
    write("frames.csv", "camera,index,exposure_mid_ns,arrival_ns\n" + std::string(text));
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  ScratchFolder folder_;
};

/// The error's message, or "" and a failed test.
template <typename T>
std::string refusal(const Result<T>& result) {
  return result ? std::string{} : result.error().message;
}

}  // namespace tripoint::test
