// What the unit tells its clients, put together from the line's verdicts and the cameras' states.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "app/latency.h"
#include "capture/camera_worker.h"
#include "line/measurement.h"
#include "ports/clock.h"
#include "serve/unit_state.h"
#include "values/side.h"
#include "values/time.h"

namespace tripoint {

/// What does not change while the unit runs.
struct UnitConstants {
  UnitIdentity identity;
  OutputLimits limits;
  bool calibrated = false;
  bool verified = false;  ///< the calibration, by a length
  bool simulated = true;  ///< simulation or recording
  Warnings warnings;      ///< of what is so by setup
};

/// Turns verdicts into the state that is published. Used by the measuring thread alone.
class UnitReport {
 public:
  UnitReport(const UnitConstants& constants, TimePoint started);

  /// A verdict of the line; `arrived` is when the last byte of the picture that brought it was there.
  void take(const Measurement& measurement, std::optional<TimePoint> arrived, const Clock& clock);

  /// The newest measurement has lost its pose for this reason, and whatever else followed from the calibration; the
  /// next verdict replaces it.
  void withdraw_pose(Fault cause);

  /// Measuring has ended: from now on the state says stopped, and no pose is valid.
  void stop() { stopped_ = true; }

  /// The state as it is to be published now.
  [[nodiscard]] UnitState state(const PerSide<CameraStatus>& cameras, const Clock& clock) const;

 private:
  [[nodiscard]] registers::State activity(const PerSide<CameraStatus>& cameras) const;
  [[nodiscard]] CameraStats stats(Side side, const CameraStatus& camera) const;

  UnitConstants constants_;
  TimePoint started_;
  std::uint16_t heartbeat_ = 0;
  bool exposure_since_start_ = false;
  bool pose_since_start_ = false;
  bool stopped_ = false;
  std::optional<PublishedMeasurement> newest_;
  LatencyWindow latency_;
};

}  // namespace tripoint
