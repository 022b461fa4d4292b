// A TCP connection to a server of this machine that closes itself.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tripoint::bench {

class LoopbackSocket {
 public:
  /// @param from  last byte of the address 127.0.0.0/8 that the server sees
  explicit LoopbackSocket(std::uint16_t port, std::uint8_t from = 1) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const int one = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    const sockaddr_in here = address(from, 0);
    const sockaddr_in there = address(1, port);
    open_ = bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) == 0 &&
            connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
  }
  LoopbackSocket(const LoopbackSocket&) = delete;
  LoopbackSocket& operator=(const LoopbackSocket&) = delete;
  ~LoopbackSocket() { ::close(socket_); }

  [[nodiscard]] int descriptor() const { return socket_; }
  [[nodiscard]] bool open() const { return open_; }
  /// To be replaced by a new connection.
  void give_up() { open_ = false; }

  /// As much as the socket takes without waiting.
  ///
  /// @return false once the connection is lost
  bool send(std::span<const std::uint8_t> bytes) {
    if (::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) < 0) open_ = open_ && would_wait();
    return open_;
  }

  /// What has come, without waiting.
  std::size_t receive(std::span<std::uint8_t> room) {
    const ssize_t got = recv(socket_, room.data(), room.size(), MSG_DONTWAIT);
    if (got == 0 || (got < 0 && !would_wait())) open_ = false;
    return got > 0 ? static_cast<std::size_t>(got) : 0;
  }

 private:
  static bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK; }
  static sockaddr_in address(std::uint8_t last, std::uint16_t port) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK - 1U + last);
    return to;
  }

  int socket_;
  bool open_ = false;
};

}  // namespace tripoint::bench
