// Cuts pictures into the payloads of an isochronous stream, each behind a header with frame id and time stamps.
// Source: UVC 1.1, 2.4.3.3 (header) and the payload specifications for uncompressed video and MJPEG.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>

#include "negotiation.h"
#include "pictures.h"

namespace tripoint::uvc {

using Time = std::chrono::steady_clock::time_point;

class Payloads {
 public:
  /// @param epoch  when frame 0 of all cameras was; frame k is k frame times later
  Payloads(const Pictures& pictures, const Playlist& playlist, Time epoch)
      : pictures_(pictures), playlist_(playlist), epoch_(epoch) {}

  void begin(const StreamChoice& choice, Time now);
  /// True when a frame is under way or due. A camera that is late leaves frames out, as a real one does.
  [[nodiscard]] bool pending(Time now) const;
  /// When the next frame is due.
  [[nodiscard]] Time next_frame() const;
  /// Writes the next payload. @return its length; 0 when nothing is due
  std::size_t write(std::span<std::uint8_t> packet, Time now);

 private:
  [[nodiscard]] std::uint64_t frame_at(Time now) const;
  void write_header(std::span<std::uint8_t> packet, bool last, Time now) const;

  const Pictures& pictures_;
  const Playlist& playlist_;
  Time epoch_;
  StreamChoice choice_;
  std::uint64_t frame_ = 0;                  ///< the newest one begun
  Bytes picture_;                            ///< that it shows
  std::span<const std::uint8_t> remaining_;  ///< of its picture
  std::uint8_t frame_id_ = 0;                ///< toggles with each frame
};

}  // namespace tripoint::uvc
