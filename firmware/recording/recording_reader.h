// A recording folder, frame by frame in the order in which the line took them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "line/observation.h"
#include "ports/frame.h"
#include "recording/frame_table.h"
#include "recording/recording_description.h"
#include "values/result.h"

namespace tripoint {

/// A frame, or what the line was told instead of one. Times are those of the recording.
using RecordedItem = std::variant<Frame, CameraLost, CameraBack>;

/// Movable; frames stay valid over a move.
class RecordingReader {
 public:
  /// Reads recording.toml and frames.csv whole; pictures only when their turn comes.
  ///
  /// @return kCannotRead, or kMalformed, kUnknownKey, kMissingKey, kOutOfRange with file and line
  static Result<RecordingReader> open(const std::filesystem::path& folder);

  /// What the next row holds; nothing when all were read. jpg comes as kMjpeg, yuyv as kYuyv, png as kYuyv or,
  /// when it has no colour, kGrey.
  ///
  /// @return the frame is valid until the next call. kCannotRead for a picture that is missing, kCorruptFrame for one
  ///   of the wrong length or size; both name the row and the file, and the next call goes on after them
  std::optional<Result<RecordedItem>> next();

  /// The picture of one row, as `next` gives it. Invalidates the frame before.
  Result<Frame> frame(const RecordedRow& row);

  /// Where the picture of a frame is.
  [[nodiscard]] std::filesystem::path picture_file(Side side, std::uint32_t index) const;

  [[nodiscard]] const RecordingDescription& description() const { return description_; }
  [[nodiscard]] std::span<const RecordedRow> rows() const { return rows_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  RecordingReader() = default;
  Result<Frame> unpacked(Frame frame, const std::filesystem::path& picture);

  std::filesystem::path folder_;
  RecordingDescription description_;
  std::vector<RecordedRow> rows_;
  std::size_t next_row_ = 0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace tripoint
