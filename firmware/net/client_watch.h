// What to say in the log about clients that were turned away or cut off.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "net/modbus_counters.h"
#include "values/time.h"

namespace tripoint {

class ClientWatch {
 public:
  /// To be asked again and again.
  ///
  /// @return the counts since the server was opened, and what to check, when one of them has grown: at once, and then
  /// no
  ///         sooner than kPause after the line before, however many clients there are
  std::optional<std::string> news(const ModbusCounters& counters, TimePoint now);

  static constexpr Duration kPause = std::chrono::seconds(10);

 private:
  ModbusCounters said_;
  std::optional<TimePoint> said_at_;
};

}  // namespace tripoint
