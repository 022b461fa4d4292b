// What outlives a single measurement: motion, health, and the forecast for the detectors.
#pragma once

#include <cstdint>
#include <optional>

#include "line/match/match.h"
#include "line/measurement.h"
#include "line/model.h"
#include "line/monitor/motion.h"
#include "values/forecast.h"
#include "values/pixel.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

class Monitor {
 public:
  /// Motion from the pose, epipolar RMS from the pairs.
  void learn(const Measurement& measurement, const Pairs& pairs);

  /// The measurement with what only the history knows: sequence, speed, settled, epipolar RMS.
  [[nodiscard]] Measurement completed(Measurement measurement, const LineModel& model) const;

  /// The next positions are not continuations of the former ones.
  void forget_motion() { motion_.forget(); }

  /// Where the target's points appear in both pictures so long after the newest common time; without points when
  /// nothing is known, also of how a target of several points is turned. The datum is one of them, with id 0, where it
  /// was seen, while that was lately: whoever looks only there sees it in every picture. One that is dark is left out,
  /// and noticed when it is lit again in the next picture that is seen whole.
  [[nodiscard]] Forecast forecast(Duration ahead, const LineModel& model) const;

 private:
  std::uint64_t learned_ = 0;  // measurements
  TimePoint common_time_{};    // the newest
  TimePoint datum_seen_{};
  PerSide<RawPixel> datum_at_;
  Motion motion_;
  std::optional<Matrix3> output_from_target_;  // rotation of the newest pose
  double epipolar_square_px2_ = 0.0;           // exponential mean
  bool epipolar_known_ = false;
};

}  // namespace tripoint
