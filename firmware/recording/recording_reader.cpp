#include "recording/recording_reader.h"

#include <fmt/format.h>

#include <utility>

#include "capture/image_file.h"
#include "capture/png_decoder.h"
#include "document/file.h"

namespace tripoint {
namespace {

constexpr std::size_t kMaxDescription_bytes = 64U << 10U;
constexpr std::size_t kMaxFrameTable_bytes = 256U << 20U;  // 20 hours of two cameras at 30 Hz
constexpr std::uintmax_t kMaxPicture_bytes = 64U << 20U;

PixelFormat format_in_memory(RecordedFormat format) {
  return format == RecordedFormat::kJpg ? PixelFormat::kMjpeg : PixelFormat::kYuyv;
}

}  // namespace

Result<RecordingReader> RecordingReader::open(const std::filesystem::path& folder) {
  RecordingReader reader;
  reader.folder_ = folder;
  const std::filesystem::path description_file = folder / "recording.toml";
  const Result<std::string> toml = read_file(description_file, kMaxDescription_bytes);
  if (!toml) return tl::make_unexpected(toml.error());
  const Result<RecordingDescription> description = recording_description_from(*toml, description_file.string());
  if (!description) return tl::make_unexpected(description.error());
  reader.description_ = *description;

  const std::filesystem::path table_file = folder / "frames.csv";
  const Result<std::string> csv = read_file(table_file, kMaxFrameTable_bytes);
  if (!csv) return tl::make_unexpected(csv.error());
  Result<std::vector<RecordedRow>> rows = recorded_rows_from(*csv, table_file.string());
  if (!rows) return tl::make_unexpected(rows.error());
  reader.rows_ = std::move(*rows);
  return reader;
}

std::optional<Result<RecordedItem>> RecordingReader::next() {
  if (next_row_ == rows_.size()) return std::nullopt;
  const RecordedRow& row = rows_[next_row_++];
  switch (row.kind) {
    case RowKind::kCameraLost:
      return RecordedItem{CameraLost{row.side, row.arrived}};
    case RowKind::kCameraBack:
      return RecordedItem{CameraBack{row.side, row.arrived}};
    case RowKind::kFrame:
      break;
  }
  return frame(row).map([](const Frame& read) { return RecordedItem{read}; });
}

Result<Frame> RecordingReader::frame(const RecordedRow& row) {
  const std::filesystem::path picture = picture_file(row.side, row.index);
  const auto about_row = [&](const Error& error) {
    return Error{error.code, fmt::format("{}:{}: {}", (folder_ / "frames.csv").string(), row.line, error.message)};
  };
  Result<std::vector<std::uint8_t>> bytes = bytes_of_file(picture, kMaxPicture_bytes);
  if (!bytes) return tl::make_unexpected(about_row(bytes.error()));
  pixels_ = std::move(*bytes);
  return unpacked({.side = row.side,
                   .format = format_in_memory(description_.format),
                   .size = description_.size,
                   .stride_bytes = 0,
                   .data = pixels_,
                   .sequence = row.index,
                   .exposed = row.exposed,
                   .arrived = row.arrived,
                   .line_time = description_.line_time},
                  picture)
      .map_error(about_row);
}

std::filesystem::path RecordingReader::picture_file(Side side, std::uint32_t index) const {
  return folder_ / name(side) / fmt::format("{:08d}.{}", index, name(description_.format));
}

/// Turns file bytes in `pixels_` into what a camera would have delivered.
Result<Frame> RecordingReader::unpacked(Frame frame, const std::filesystem::path& picture) {
  const auto corrupt = [&](std::string_view why) {
    return failure(ErrorCode::kCorruptFrame, fmt::format("{}: {}", picture.string(), why));
  };
  if (description_.format == RecordedFormat::kJpg) return frame;
  if (description_.format == RecordedFormat::kYuyv) {
    frame.stride_bytes = static_cast<std::size_t>(frame.size.width_px) * 2;
    const std::size_t expected = frame.stride_bytes * static_cast<std::size_t>(frame.size.height_px);
    if (pixels_.size() != expected) return corrupt(fmt::format("{} bytes, must be {}", pixels_.size(), expected));
    return frame;
  }
  Result<PackedPicture> png = picture_from_png(pixels_);
  if (!png) return corrupt(png.error().message);
  if (png->size != frame.size) {
    return corrupt(fmt::format("{}x{}, must be {}x{}", png->size.width_px, png->size.height_px, frame.size.width_px,
                               frame.size.height_px));
  }
  pixels_ = std::move(png->data);
  frame.format = png->format;
  frame.stride_bytes = png->stride_bytes;
  frame.data = pixels_;
  return frame;
}

}  // namespace tripoint
