// A TCP connection on this machine that can be waited for, with a limit on every wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace tripoint::uvc {

/// Owns one open socket; closes it.
class Socket {
 public:
  /// Listens on 127.0.0.1, on a port that the system picks. Throws std::system_error.
  static Socket listening();

  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  Socket(Socket&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  Socket& operator=(Socket&& other) = delete;
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket();

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] bool readable_within(std::chrono::nanoseconds limit) const;
  /// The next connection, nothing when none came in time.
  [[nodiscard]] std::optional<Socket> accepted_within(std::chrono::nanoseconds limit) const;

  /// False when the other side is gone or has been silent for a minute.
  [[nodiscard]] bool read_exactly(std::span<std::uint8_t> bytes) const;
  [[nodiscard]] bool write_all(std::span<const std::uint8_t> bytes) const;

 private:
  int descriptor_;
};

}  // namespace tripoint::uvc
