// recording.toml: what kind of pictures a recording folder holds.
#pragma once

#include <cstdint>
#include <string_view>

#include "values/pixel.h"
#include "values/result.h"
#include "values/time.h"

namespace tripoint {

enum class RecordedFormat : std::uint8_t { kJpg, kYuyv, kPng };

/// Also the extension of the picture files.
constexpr std::string_view name(RecordedFormat format) {
  switch (format) {
    case RecordedFormat::kJpg:
      return "jpg";
    case RecordedFormat::kYuyv:
      return "yuyv";
    case RecordedFormat::kPng:
      break;
  }
  return "png";
}

struct RecordingDescription {
  RecordedFormat format = RecordedFormat::kYuyv;
  ImageSize size;
  Duration line_time{0};
  Duration utc_offset{0};  ///< added to the recording's times it gives nanoseconds since 1970 UTC
};

/// @return kMalformed, kUnknownKey, kMissingKey or kOutOfRange with file, line and permitted values
Result<RecordingDescription> recording_description_from(std::string_view toml, std::string_view file_name);

}  // namespace tripoint
