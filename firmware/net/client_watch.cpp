#include "net/client_watch.h"

#include <fmt/format.h>

#include <tuple>

namespace tripoint {
namespace {

auto troubles(const ModbusCounters& counters) {
  return std::tie(counters.refused, counters.displaced, counters.timed_out, counters.broken, counters.internal);
}

std::string line_of(const ModbusCounters& counters) {
  return fmt::format(
      "modbus: {} connected; since the start {} refused, {} displaced by newcomers, {} silent or slow, {} not speaking "
      "Modbus TCP, {} failures of the system; see modbus.max_connections and modbus.allowed_clients, and that each "
      "client keeps one connection",
      counters.connected, counters.refused, counters.displaced, counters.timed_out, counters.broken, counters.internal);
}

}  // namespace

std::optional<std::string> ClientWatch::news(const ModbusCounters& counters, TimePoint now) {
  if (troubles(counters) == troubles(said_)) return std::nullopt;
  if (said_at_ && now - *said_at_ < kPause) return std::nullopt;
  said_ = counters;
  said_at_ = now;
  return line_of(counters);
}

}  // namespace tripoint
