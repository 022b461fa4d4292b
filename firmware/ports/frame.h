// One picture as a camera delivers it, and the same picture as planes that a detector can read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "values/fixed_vector.h"
#include "values/pixel.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

enum class PixelFormat : std::uint8_t { kYuyv, kMjpeg, kGrey };

/// A view of a camera's own buffer; valid until the camera is asked for the next frame.
struct Frame {
  Side side = Side::kLeft;
  PixelFormat format = PixelFormat::kYuyv;
  ImageSize size;
  std::size_t stride_bytes = 0;  ///< of a row; 0 for MJPEG
  std::span<const std::uint8_t> data;
  std::uint32_t sequence = 0;  ///< the driver's number: a dropped frame leaves a gap
  TimePoint exposed{};         ///< middle of the exposure of row 0
  TimePoint arrived{};         ///< when the last byte was here
  Duration line_time{0};       ///< row r is exposed r times this later (rolling shutter)
};

/// One plane: value (x, y) is data[y * stride_bytes + x * step_bytes].
struct Plane {
  const std::uint8_t* data = nullptr;
  std::size_t stride_bytes = 0;
  std::size_t step_bytes = 1;

  [[nodiscard]] const std::uint8_t* row(int y) const { return data + static_cast<std::size_t>(y) * stride_bytes; }
  [[nodiscard]] std::uint8_t at(int x, int y) const { return row(y)[static_cast<std::size_t>(x) * step_bytes]; }
};

/// Rows of a picture, from side to side.
struct RowBand {
  int top_px = 0;
  int bottom_px = 0;  ///< first row below it
  friend bool operator==(const RowBand&, const RowBand&) = default;
};

inline constexpr std::size_t kMaxBands = 13;  ///< one for each point of a target and for a datum
using RowBands = FixedVector<RowBand, kMaxBands>;

/// A decoded picture: full-size luma, chroma at half width and, when `chroma_rows_halved`, half height.
/// Chroma planes are absent (null) for GREY. In YUYV all three look into the camera's buffer.
struct Picture {
  ImageSize size;
  Plane luma;
  Plane u;
  Plane v;
  bool chroma_rows_halved = false;
  bool interleaved_yuyv = false;  ///< luma.data is the start of a YUYV buffer
  std::uint32_t frame = 0;        ///< the driver's number
  RowBands bands{};  ///< the rows that were decoded, from above, apart; empty = all. Others hold old values
};

/// The planes of an unpacked YUYV or GREY frame, without copying. MJPEG needs capture's decoder.
Picture picture_of(const Frame& frame);

}  // namespace tripoint
