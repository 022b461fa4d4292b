#include "ports/frame.h"

#include "values/assert.h"

namespace tripoint {

Picture picture_of(const Frame& frame) {
  TRIPOINT_ASSERT(frame.format != PixelFormat::kMjpeg);
  const std::uint8_t* start = frame.data.data();
  if (frame.format == PixelFormat::kGrey) {
    return {.size = frame.size, .luma = {start, frame.stride_bytes, 1}, .u = {}, .v = {}, .frame = frame.sequence};
  }
  return {.size = frame.size,
          .luma = {start, frame.stride_bytes, 2},
          .u = {start + 1, frame.stride_bytes, 4},
          .v = {start + 3, frame.stride_bytes, 4},
          .chroma_rows_halved = false,
          .interleaved_yuyv = true,
          .frame = frame.sequence};
}

}  // namespace tripoint
