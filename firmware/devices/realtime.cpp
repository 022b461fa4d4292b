#include "devices/realtime.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>

#include <system_error>

namespace tripoint {

Result<void> take_realtime_priority(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  if (error == 0) return {};
  return failure(ErrorCode::kControlRefused,
                 fmt::format("no real-time priority ({}); it may wait under load; grant LimitRTPRIO or CAP_SYS_NICE",
                             std::generic_category().message(error)));
}

}  // namespace tripoint
