// From configuration, calibration and target to what the line and the registers need to know.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/measured_target.h"
#include "app/measuring.h"
#include "app/unit_report.h"
#include "calibration/calibration.h"
#include "config/config.h"
#include "config/target_file.h"
#include "line/model.h"
#include "values/result.h"

namespace tripoint {

struct UnitSetup {
  std::shared_ptr<const LineModel> model;  ///< null: no calibration is configured; shared with the line
  std::optional<Calibration> calibration;
  UnitConstants constants;
  MeasuredTarget target;
};

/// Loads the files that the configuration names and checks that they belong together.
///
/// @return the error of the file that is missing or wrong; kMismatch when the target or the configuration needs another
/// detector; as check_datum
Result<UnitSetup> unit_setup(const Config& config);

/// Whether the line can measure with the detector that is configured.
///
/// @return kMismatch for spheres: they are found in single pictures only
Result<void> check_detector(const Config& config);

/// @return kMismatch when the target is not made of what the detector finds, or its tags make no triangle for the
/// paper's
///         method; of an unknown family or tag as detection_of
Result<MeasuredTarget> measured_target(const TargetFile& file, const Config& config);

/// The model of the line for a calibration and a target, with the limits and the volume of a configuration.
///
/// @return as rig_of
Result<LineModel> line_model(const Calibration& calibration, const Target& target, const Config& config);

/// As people compare it with a PLC's: decimal, and in hex.
std::string setup_text(std::uint16_t setup);

/// Whether the cameras are those of the calibration: picture size and serial; without a serial, or when both cameras
/// have the same, the port as well. Pictures of a recording are judged by their size alone. A camera that does not
/// deliver keeps the judgement it had.
CalibrationFits fits_calibration(const std::optional<Calibration>& calibration, CameraSource source);

}  // namespace tripoint
