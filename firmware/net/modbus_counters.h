// What a Modbus server has been through.
#pragma once

#include <cstdint>

namespace tripoint {

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

}  // namespace tripoint
