// Time as the whole product uses it: monotonic, in nanoseconds. Wall-clock time exists only at the edges.
#pragma once

#include <chrono>
#include <cstdint>

namespace tripoint {

using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::steady_clock, Duration>;

constexpr TimePoint time_from_ns(std::int64_t ns) { return TimePoint{Duration{ns}}; }
constexpr std::int64_t ns_from_time(TimePoint time) { return time.time_since_epoch().count(); }
constexpr double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }
constexpr Duration duration_from_seconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

}  // namespace tripoint
