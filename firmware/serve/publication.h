// Where the measuring thread leaves the newest state and the Modbus thread finds it.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "serve/latch.h"
#include "serve/unit_state.h"
#include "serve/warning_hold.h"
#include "values/time.h"

namespace tripoint {

/// What one answer is made from: a state that nobody changes any more, and the latch as it stood with it.
struct Edition {
  std::shared_ptr<const UnitState> state;  ///< never null; shared with the publisher, which has moved on
  Latch latch;
  Warnings held;  ///< of this state and of those before it, see WarningHold
};

/// Every reader gets one whole state. The lock is held for the exchange of pointers; only a latch copies under it.
class Publication {
 public:
  explicit Publication(UnitState first);

  /// Called by one thread, for each measurement and whenever something else that is published has changed.
  void publish(UnitState state, TimePoint now);

  [[nodiscard]] Edition newest(TimePoint now);

  /// A latch command or a trigger edge; `at` is the moment after which pictures count.
  ///
  /// @return the number of the latch that will answer it
  std::uint32_t request_latch(TimePoint at);

 private:
  std::mutex mutex_;
  std::shared_ptr<const UnitState> state_;  // shared with the answers that are being made from it
  Latch latch_;
  WarningHold warnings_;
};

}  // namespace tripoint
