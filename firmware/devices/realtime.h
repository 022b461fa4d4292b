// Real-time priority for the threads that work briefly and are waited for: the one that answers, the one that measures.
//
// The kernel lets an ordinary thread that was woken wait until the one that woke it has had its share: milliseconds.
#pragma once

#include "values/result.h"

namespace tripoint {

/// Gives the calling thread SCHED_FIFO at `priority` (1 to 99).
///
/// @return kControlRefused when the system does not permit it; the message is for the log, the thread runs on as it was
Result<void> take_realtime_priority(int priority);

}  // namespace tripoint
