// One Modbus client: reads requests, answers them in turns, and never waits longer than its deadline.
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "net/framing.h"
#include "net/network.h"
#include "values/time.h"

namespace tripoint {

class Connection;

/// What a connection asks of the server that owns it.
struct ConnectionHost {
  std::function<TimePoint()> now;
  std::function<Pdu(std::span<const std::uint8_t> request, const Connection& client)> answer;
  std::function<void(const Connection& client, bool broken)> closed;
};

struct ConnectionLimits {
  Duration frame{};
  Duration write{};
  Duration idle{};
  Duration pace{};
};

/// Kept alive by the operation that is under way (hence shared) and by the host's list.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  /// @param host must outlive the connection
  /// @param may_command named in modbus.command_clients
  Connection(boost::asio::ip::tcp::socket socket, const ClientAddress& address, bool may_command,
             const ConnectionHost& host, const ConnectionLimits& limits);

  void start();
  void close();

  [[nodiscard]] const ClientAddress& address() const { return address_; }
  [[nodiscard]] TimePoint last_heard() const { return last_heard_; }
  [[nodiscard]] bool has_asked() const { return has_asked_; }
  [[nodiscard]] TimePoint deadline() const { return deadline_; }

  [[nodiscard]] bool may_command() const { return may_command_; }

 private:
  void read();
  void taken(std::size_t bytes);
  void take_turn();
  void send();
  void sent();
  void go_on();
  void shut(bool broken);

  boost::asio::ip::tcp::socket socket_;
  boost::asio::steady_timer pause_;
  ClientAddress address_;
  bool may_command_;
  const ConnectionHost& host_;
  ConnectionLimits limits_;
  TimePoint last_heard_{};
  bool has_asked_ = false;
  TimePoint deadline_{};
  TimePoint paid_until_{};  ///< requests so far, each worth limits_.pace
  std::array<std::uint8_t, kTurnBytes> input_{};
  std::size_t have_ = 0;
  bool partial_ = false;  ///< the first bytes of a request are here: its deadline runs and is not moved
  Turn turn_;
};

}  // namespace tripoint
