// Both cameras' clocks, and how well their stamps agree.
#pragma once

#include "line/align/stamp_clock.h"
#include "line/observation.h"
#include "values/side.h"

namespace tripoint {

class Clocks {
 public:
  /// @param offset_prior_s  standard deviation of the unknown offset between the cameras' stamps
  void trust_offset_to(double offset_prior_s) { offset_prior_s_ = offset_prior_s; }

  /// Learns from an observation's stamp; a camera that was lost or has come back starts anew.
  void take(const Event& event);

  const StampClock& operator[](Side side) const { return clocks_[side]; }

  /// Standard deviation of the offset between both cameras' times: the prior and both regressions.
  [[nodiscard]] double offset_sigma_s() const;

 private:
  PerSide<StampClock> clocks_;
  double offset_prior_s_ = 0.0;
};

}  // namespace tripoint
