// Real-time priority for the thread that answers: under full vision load it keeps answers below a millisecond.
#pragma once

#include "values/result.h"

namespace tripoint {

/// Gives the calling thread SCHED_FIFO at `priority` (1 to 99).
///
/// @return kControlRefused when the system does not permit it; the message is for the log, the thread runs on as it was
Result<void> take_realtime_priority(int priority);

}  // namespace tripoint
