// A server on a free port of the loopback network, run by a thread of its own as in the unit.
#pragma once

#include <pthread.h>

#include <chrono>
#include <ctime>
#include <functional>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "net/modbus_server.h"
#include "serve/publication.h"

namespace tripoint::test {

inline ModbusSettings any_port() {
  ModbusSettings settings;
  settings.port = 0;
  settings.command_clients = {client_network_from("127.0.0.1").value()};
  return settings;
}

inline TimePoint monotonic_now() { return std::chrono::time_point_cast<Duration>(std::chrono::steady_clock::now()); }

inline void quiet(std::string_view /*what*/) {}

class Served {
 public:
  explicit Served(const ModbusSettings& settings = any_port(), Now now = monotonic_now, Say say = quiet)
      : server(ModbusServer::open(settings, responder, std::move(now), std::move(say)).value()),
        thread_([this](const std::stop_token& stop) { server.run(stop); }) {}

  /// Waits until the counters say so, or gives up.
  [[nodiscard]] bool eventually(const std::function<bool(const ModbusCounters&)>& condition) const {
    for (int i = 0; i < 500; ++i) {
      if (condition(server.counters())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// What the server's thread has worked so far.
  [[nodiscard]] Duration processor_time() {
    clockid_t clock{};
    timespec time{};
    pthread_getcpuclockid(thread_.native_handle(), &clock);
    clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + Duration{time.tv_nsec};
  }

  Publication publication{UnitState{}};
  Responder responder{publication, DeviceIdentification{}};
  ModbusServer server;

 private:
  std::jthread thread_;
};

}  // namespace tripoint::test
