// The Modbus TCP server: one thread, many clients, none of which can hold up another.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "contract/registers.h"
#include "net/network.h"
#include "serve/responder.h"
#include "values/result.h"
#include "values/time.h"

namespace tripoint {

struct ModbusSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 1502;  ///< 0: any free one, see ModbusServer::port
  std::size_t most_connections = registers::server::kMostConnections;
  std::vector<ClientNetwork> allowed_clients;  ///< empty: everyone
  std::vector<ClientNetwork> command_clients;  ///< who may write register 1000; empty: nobody
  Duration frame_limit =
      std::chrono::milliseconds(registers::server::kFrameMs);  ///< from the first byte of a request to its last
  Duration write_limit =
      std::chrono::milliseconds(registers::server::kWriteMs);  ///< until a client has taken its answers
  Duration idle_limit = std::chrono::milliseconds(registers::server::kIdleMs);  ///< without any request
  Duration request_pace = std::chrono::microseconds(
      registers::server::kPaceUs);  ///< sustained time per request of one client; faster ones wait
};

/// Since the server was opened.
struct ModbusCounters {
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;    ///< full, and the address held most; or not on the allow-list
  std::uint64_t displaced = 0;  ///< gave way to a newcomer
  std::uint64_t timed_out = 0;  ///< past one of the limits
  std::uint64_t broken = 0;     ///< sent something that is not Modbus TCP
  std::uint64_t requests = 0;
  std::uint64_t internal = 0;   ///< failures of the system while serving (no memory, no descriptor)
  std::uint16_t connected = 0;  ///< now
};

using Now = std::function<TimePoint()>;

class ModbusServer {
 public:
  /// Listens at once; answers once run() runs. `responder` must outlive the server.
  ///
  /// @return kAddressInUse when the port is taken; kOutOfRange when the address is not one of this machine or the port
  ///         is not permitted; kDeviceFault for any other refusal of the system
  static Result<ModbusServer> open(const ModbusSettings& settings, Responder& responder, Now now);

  ModbusServer(ModbusServer&&) noexcept;
  ModbusServer& operator=(ModbusServer&&) noexcept;
  ~ModbusServer();

  /// Serves until `stop` is requested; called by one thread.
  void run(const std::stop_token& stop);

  [[nodiscard]] std::uint16_t port() const;

  /// From any thread.
  [[nodiscard]] ModbusCounters counters() const;

 private:
  class Impl;
  explicit ModbusServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace tripoint
