// A Modbus client that can behave badly: plain sockets, every wait limited.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace tripoint::test {

using Bytes = std::vector<std::uint8_t>;
using std::chrono::milliseconds;

inline constexpr milliseconds kPatience{5000};  // generous: the machine that runs the tests is shared

inline Bytes frame_of(std::uint16_t transaction, const Bytes& pdu) {
  const std::size_t length = pdu.size() + 1;
  Bytes frame(6 + length);
  const auto put = [&](std::size_t at, std::size_t word) {
    frame[at] = static_cast<std::uint8_t>(word >> 8U);
    frame[at + 1] = static_cast<std::uint8_t>(word & 0xFFU);
  };
  put(0, transaction);
  put(4, length);
  frame[6] = 255;
  std::copy(pdu.begin(), pdu.end(), frame.begin() + 7);
  return frame;
}

/// FC 3 of 32 to 147, as every client does it.
inline Bytes pose_request(std::uint16_t transaction = 1) { return frame_of(transaction, {3, 0, 32, 0, 116}); }
inline constexpr std::size_t kPoseAnswerBytes = 7 + 2 + 232;

class Client {
 public:
  /// @param local address of the loopback network to come from
  explicit Client(std::uint16_t port, const char* local = "127.0.0.1") : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in from{};
    from.sin_family = AF_INET;
    inet_pton(AF_INET, local, &from.sin_addr);
    sockaddr_in to = from;
    to.sin_port = htons(port);
    inet_pton(AF_INET, "127.0.0.1", &to.sin_addr);
    const int one = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    connected_ = bind(socket_, address_of(from), sizeof from) == 0 && connect(socket_, address_of(to), sizeof to) == 0;
  }
  Client(Client&& other) noexcept : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
  Client& operator=(Client&&) = delete;
  ~Client() {
    if (socket_ >= 0) ::close(socket_);
  }

  [[nodiscard]] bool connected() const { return connected_; }

  /// As much as the kernel takes at once.
  std::size_t send(std::span<const std::uint8_t> bytes) const {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    return sent < 0 ? 0 : static_cast<std::size_t>(sent);
  }

  /// @return what came within `limit`; fewer bytes when the server closed or the time was up
  [[nodiscard]] Bytes receive(std::size_t count, milliseconds limit = kPatience) const {
    Bytes bytes;
    const auto end = std::chrono::steady_clock::now() + limit;
    while (bytes.size() < count && wait_until(end)) {
      Bytes part(count - bytes.size());
      const ssize_t got = recv(socket_, part.data(), part.size(), 0);
      if (got <= 0) break;
      bytes.insert(bytes.end(), part.begin(), part.begin() + got);
    }
    return bytes;
  }

  [[nodiscard]] Bytes ask(const Bytes& frame, std::size_t answer_bytes) const {
    send(frame);
    return receive(answer_bytes);
  }

  /// A whole pose answer came.
  [[nodiscard]] bool is_served() const { return ask(pose_request(), kPoseAnswerBytes).size() == kPoseAnswerBytes; }

  /// The server has closed this connection (whatever it had sent before).
  [[nodiscard]] bool is_closed(milliseconds limit = kPatience) const {
    const auto end = std::chrono::steady_clock::now() + limit;
    Bytes part(4096);
    while (wait_until(end)) {
      if (recv(socket_, part.data(), part.size(), 0) <= 0) return true;
    }
    return false;
  }

 private:
  static const sockaddr* address_of(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

  [[nodiscard]] bool wait_until(std::chrono::steady_clock::time_point end) const {
    const auto left = std::chrono::duration_cast<milliseconds>(end - std::chrono::steady_clock::now());
    pollfd ready{socket_, POLLIN, 0};
    return left.count() > 0 && poll(&ready, 1, static_cast<int>(left.count())) > 0;
  }

  int socket_;
  bool connected_ = false;
};

}  // namespace tripoint::test
