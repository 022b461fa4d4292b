// Where pictures come from: the only place that picks real, simulated or recorded cameras.
#pragma once

#include "app/measured_target.h"
#include "capture/camera_worker.h"
#include "config/config.h"
#include "ports/clock.h"
#include "sim/simulated_leds.h"
#include "values/linear.h"
#include "values/result.h"
#include "values/side.h"

namespace tripoint {

/// How to open each camera, again and again.
///
/// @param target    whose LEDs or tags a simulation shows
/// @param clock     must outlive the cameras
/// @param switched  lines that switch the LEDs of a simulation, and outlive the cameras; null: they are always lit
/// @return errors of a simulation's trajectory or tags, or of a recording's folder; a real camera that is absent is not
/// an error
///   here: its worker keeps trying
Result<PerSide<OpenCamera>> camera_supply(const Config& config, const MeasuredTarget& target, const Clock& clock,
                                          const SimulatedLeds* switched = nullptr);

/// Simulated cameras that see a single LED held still at this place of the reference frame.
///
/// @param clock must outlive the cameras
Result<PerSide<OpenCamera>> simulated_cameras_showing(const Config& config, const Clock& clock,
                                                      const Vec3& place_in_reference_mm);

/// As camera_supply, but simulated cameras see a calibration board, held still in the middle of the working volume,
/// and no LED.
///
/// @param clock must outlive the cameras
Result<PerSide<OpenCamera>> cameras_before_board(const Config& config, const Clock& clock);

/// True when nothing real is measured.
constexpr bool is_simulated(CameraSource source) { return source != CameraSource::kV4l2; }

}  // namespace tripoint
