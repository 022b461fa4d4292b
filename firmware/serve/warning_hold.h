// A warning stays for a while after its cause, so that a client which looks now and then sees it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "line/measurement.h"
#include "values/time.h"

namespace tripoint {

inline constexpr Duration kWarningHold{10'000'000'000};  ///< registers.md: a warning stays at least 10 s

class WarningHold {
 public:
  void take(Warnings warnings, TimePoint now) {
    for (std::size_t bit = 0; bit < seen_.size(); ++bit) {
      if (warnings.contains(static_cast<Warning>(bit))) seen_[bit] = now;
    }
  }

  /// Every warning that was taken within the last kWarningHold.
  [[nodiscard]] Warnings held(TimePoint now) const {
    Warnings warnings;
    for (std::size_t bit = 0; bit < seen_.size(); ++bit) {
      if (seen_[bit] && now - *seen_[bit] <= kWarningHold) warnings.insert(static_cast<Warning>(bit));
    }
    return warnings;
  }

 private:
  std::array<std::optional<TimePoint>, 16> seen_;
};

}  // namespace tripoint
