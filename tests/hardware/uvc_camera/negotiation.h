// Which format and rate the host and the camera agree on before a stream starts (UVC 1.1, 4.3.1.1: probe and commit).
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "descriptors.h"
#include "usbip.h"

namespace tripoint::uvc {

struct StreamChoice {
  Format format = Format::kYuyv;
  std::uint32_t interval = kIntervals.front();  ///< in 100 ns

  [[nodiscard]] std::chrono::nanoseconds frame_time() const {
    return std::chrono::nanoseconds{std::int64_t{interval} * 100};
  }
};

class Negotiation {
 public:
  /// The data to answer with (empty for a set); nothing when the request is refused.
  std::optional<Bytes> answer(const Setup& setup, std::span<const std::uint8_t> sent);
  /// What the host committed to last.
  [[nodiscard]] const StreamChoice& committed() const { return committed_; }

 private:
  StreamChoice probed_;
  StreamChoice committed_;
};

}  // namespace tripoint::uvc
