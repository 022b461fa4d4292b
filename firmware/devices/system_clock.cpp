#include "devices/system_clock.h"

#include <ctime>

#include <sys/timex.h>

namespace tripoint {
namespace {

Duration read(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::chrono::seconds{time.tv_sec} + Duration{time.tv_nsec};
}

}  // namespace

TimePoint SystemClock::now() const { return TimePoint{read(CLOCK_MONOTONIC)}; }

Duration SystemClock::utc_offset() const {
  // The middle of two monotonic readings belongs to the wall clock's reading between them.
  const Duration before = read(CLOCK_MONOTONIC);
  const Duration wall = read(CLOCK_REALTIME);
  const Duration after = read(CLOCK_MONOTONIC);
  return wall - (before + (after - before) / 2);
}

bool SystemClock::synchronised() const {
  timex state{};  // modes 0: read only
  const int result = adjtimex(&state);
  return result >= 0 && result != TIME_ERROR && (state.status & STA_UNSYNC) == 0;
}

}  // namespace tripoint
