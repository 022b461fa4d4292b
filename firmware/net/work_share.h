// How much of a processor a thread may take, however much is asked of it.
#pragma once

#include "values/time.h"

namespace tripoint {

/// The thread may work for half of the time; what it works beyond that it has to rest off.
class WorkShare {
 public:
  /// To be asked after each piece of work.
  ///
  /// @param worked  processor time of the thread so far
  /// @param now     by a clock that does not go back
  /// @return        how long to rest before going on; none, or at least twice kWorthARest
  Duration rest_after(Duration worked, TimePoint now);

  static constexpr Duration kWorthARest{500'000};   ///< work beyond its share from which on the thread rests
  static constexpr Duration kMostSaved{2'000'000};  ///< share that was not used and may still be, after a quiet time

 private:
  Duration worked_{0};
  TimePoint now_{};
  Duration beyond_{-kMostSaved};  // of its share
};

}  // namespace tripoint
