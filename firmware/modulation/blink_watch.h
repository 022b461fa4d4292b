// What to say about a camera in which no LED blinks, and when it is over.
#pragma once

#include <optional>
#include <string>

#include "modulation/blinking_leds.h"
#include "values/time.h"

namespace tripoint {

class BlinkWatch {
 public:
  /// To be given what BlinkingLeds found in each picture.
  ///
  /// @return once, when no LED was believed for kPatience: how many red lights shine on, and what to check; and once
  ///         when one is believed again
  std::optional<std::string> news(const FixedVector<SpotVerdict, kMaxImagePoints>& verdicts, TimePoint arrived);

  static constexpr Duration kPatience = std::chrono::seconds(1);

 private:
  std::optional<TimePoint> last_believed_;
  bool missing_ = false;
};

}  // namespace tripoint
