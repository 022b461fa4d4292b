// Whether a full pose agrees with one shortly before it: identical LEDs are told by geometry, and chance has geometry
// too.
#pragma once

#include <chrono>
#include <optional>

#include "line/measurement.h"
#include "values/linear.h"
#include "values/time.h"

namespace tripoint {

/// Lights that are none of the target's can lie as a hidden LED would: about once in 75,000 views among many lights
/// (bench_identity), which at 60 verdicts a second is every twenty minutes. They hardly do so twice in a row in
/// agreement with the motion, so that a pose is believed when the verdict before, believed or not, or the last that
/// was believed says the same. A target that comes into view has its first pose one verdict later.
class Confirmation {
 public:
  /// The measurement, with kAmbiguous in place of a pose that nothing confirms, and its points without identity. One
  /// of a target without orientation passes.
  Measurement judged(Measurement measurement);

  void forget();

  static constexpr Duration kMemory = std::chrono::milliseconds(300);
  static constexpr double kFastest_mm_per_s = 2000.0;
  static constexpr double kFastestTurn_rad_per_s = 10.0;
  static constexpr double kFarthest_mm = 50.0;      ///< whatever the time that has passed and the noise allow
  static constexpr double kFarthestTurn_rad = 0.3;  ///< likewise

 private:
  struct Seen {
    TimePoint at{};
    TargetPose pose;
  };

  static bool agree(const Seen& before, const Seen& now);

  std::optional<Seen> last_;
  std::optional<Seen> last_believed_;
};

}  // namespace tripoint
