// The Modbus TCP server: one thread, many clients, none of which can hold up another.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "contract/registers.h"
#include "net/modbus_counters.h"
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

using Now = std::function<TimePoint()>;
using Say = std::function<void(std::string_view)>;  ///< for the log, at most once in ClientWatch::kPause

class ModbusServer {
 public:
  /// Listens at once; answers once run() runs. `responder` must outlive the server.
  ///
  /// @return kAddressInUse when the port is taken; kOutOfRange when the address is not one of this machine or the port
  ///         is not permitted; kDeviceFault for any other refusal of the system
  static Result<ModbusServer> open(const ModbusSettings& settings, Responder& responder, Now now, Say say);

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
