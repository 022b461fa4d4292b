#include "line/align/patience.h"

namespace tripoint {

Aligned Patience::judged(Aligned seen, const Tracks& tracks) {
  const bool both_deliver = !tracks.lost(Side::kLeft) && !tracks.lost(Side::kRight);
  if (!seen.due && both_deliver && waiting_since_ && tracks.now() - *waiting_since_ > limit_) {
    seen.due = true;
    seen.faults.insert(Fault::kTimingBound);
  }
  if (seen.due || !both_deliver || !waiting_since_) waiting_since_ = tracks.now();
  return seen;
}

}  // namespace tripoint
