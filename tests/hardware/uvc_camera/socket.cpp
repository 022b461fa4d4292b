#include "socket.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace tripoint::uvc {
namespace {

constexpr timeval kSilenceLimit{60, 0};

void require(bool done, const char* what) {
  if (!done) throw std::system_error(errno, std::generic_category(), what);
}

sockaddr_in any_loopback_port() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

Socket Socket::listening() {
  Socket socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  require(socket.descriptor_ >= 0, "socket");
  const sockaddr_in address = any_loopback_port();
  require(::bind(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, "bind");
  require(::listen(socket.descriptor_, 4) == 0, "listen");
  return socket;
}

Socket::~Socket() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint16_t Socket::port() const {
  sockaddr_in address{};
  socklen_t length = sizeof address;
  require(::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &length) == 0, "getsockname");
  return ntohs(address.sin_port);
}

bool Socket::readable_within(std::chrono::nanoseconds limit) const {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limit);
  const timespec timeout{seconds.count(), (limit - seconds).count()};
  pollfd watched{descriptor_, POLLIN, 0};
  return ::ppoll(&watched, 1, &timeout, nullptr) > 0;
}

std::optional<Socket> Socket::accepted_within(std::chrono::nanoseconds limit) const {
  if (!readable_within(limit)) return std::nullopt;
  Socket connection{::accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC)};
  if (connection.descriptor_ < 0) return std::nullopt;
  const int one = 1;
  ::setsockopt(connection.descriptor_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
  ::setsockopt(connection.descriptor_, SOL_SOCKET, SO_RCVTIMEO, &kSilenceLimit, sizeof kSilenceLimit);
  ::setsockopt(connection.descriptor_, SOL_SOCKET, SO_SNDTIMEO, &kSilenceLimit, sizeof kSilenceLimit);
  return connection;
}

bool Socket::read_exactly(std::span<std::uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool Socket::write_all(std::span<const std::uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace tripoint::uvc
