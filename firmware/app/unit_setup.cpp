#include "app/unit_setup.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "app/camera_supply.h"
#include "app/version.h"
#include "document/sha256.h"

namespace tripoint {
namespace {

OutputFrame output_frame(ConfiguredFrame frame) {
  return frame == ConfiguredFrame::kLeftCamera ? OutputFrame::kLeftCamera : OutputFrame::kReference;
}

Limits limits_of(const Config& config) {
  Limits limits;
  limits.camera_silence = config.cameras.loss_after;
  limits.timing_bound_mm = config.timing.bound_mm;
  limits.offset_prior_s = config.timing.offset_prior_ms * 1e-3;
  limits.settled_mm_per_s = config.output.settled_mm_per_s;
  return limits;
}

Result<Target> points_of(const TargetFile& file) {
  if (file.kind != TargetKind::kLed) {
    return failure(ErrorCode::kMismatch,
                   "the target is made of AprilTags, but detector.kind is \"led\": permitted is a target of LEDs");
  }
  Target target;
  for (const TargetFilePoint& point : file.points) {
    target.points.push_back({point.id, point.position_mm, point.uncertainty_mm, point.facing});
  }
  if (file.facing) target.facing = *file.facing;
  return target;
}

/// Register 146: over everything that changes what a pose means; a client stores it at commissioning. Never 0.
std::uint16_t setup_number(const Config& config, const std::optional<Calibration>& calibration,
                           const TargetFile& target) {
  std::string text = canonical_text(config, kSetupTables);
  text.append(target.sha256.begin(), target.sha256.end());
  if (calibration) text.append(calibration->sha256.begin(), calibration->sha256.end());
  return static_cast<std::uint16_t>(std::max<std::uint32_t>(id_from(sha256(text)) >> 16U, 1U));
}

/// Cheap cameras come without a serial, or all with the same.
bool has_unique_serials(const Calibration& calibration) {
  const PerSide<std::string>& serial = calibration.serial;
  return !serial.left.empty() && !serial.right.empty() && serial.left != serial.right;
}

UnitConstants constants_of(const Config& config, const std::optional<Calibration>& calibration,
                           const TargetFile& target) {
  UnitConstants constants;
  constants.identity.serial_number = config.modbus.serial_number;
  constants.identity.firmware = kVersion;
  constants.identity.calibration_id = calibration ? calibration->id : 0;
  constants.identity.configuration_id = config.id;
  constants.identity.output_frame = output_frame(config.output.frame);
  constants.identity.setup = setup_number(config, calibration, target);
  constants.limits = {.age_limit = config.output.age_limit, .latch_hold = config.output.latch_hold};
  constants.calibrated = calibration.has_value();
  constants.simulated = is_simulated(config.cameras.source);
  if (calibration) {
    constants.verified = verified_by_length(*calibration);
    constants.unique_serials = has_unique_serials(*calibration);
  }
  return constants;
}

/// Pictures of another size than the calibration's cannot be measured; of a recording only its frames can tell.
Result<void> check_size(const Config& config, const Calibration& calibration) {
  if (config.cameras.source == CameraSource::kRecording) return {};
  for (const Side side : kBothSides) {
    const ImageSize& size = calibration.stereo.cameras[side].size;
    if (size == config.cameras.size) continue;
    return failure(
        ErrorCode::kMismatch,
        fmt::format("made at {}x{} px ({} camera), but cameras.width_px and height_px ask for {}x{}: set that "
                    "size, or use another calibration",
                    size.width_px, size.height_px, name(side), config.cameras.size.width_px,
                    config.cameras.size.height_px));
  }
  return {};
}

}  // namespace

Result<void> check_detector(const Config& config) {
  if (config.detector.kind == ConfiguredDetector::kLed) return {};
  return tl::make_unexpected(
      named_by(config, "detector.kind",
               {ErrorCode::kMismatch,
                fmt::format("\"{}\" is for single pictures, with `tripointd detect`: to measure or "
                            "expose set \"led\"",
                            config.detector.kind == ConfiguredDetector::kSphere ? "sphere" : "apriltag")}));
}

Result<LineModel> line_model(const Calibration& calibration, const TargetFile& target, const Config& config) {
  const Result<Target> points = points_of(target);
  if (!points) return tl::make_unexpected(points.error());
  return rig_of(calibration.stereo).map([&](const Rig& rig) {
    LineModel model;
    model.calibration = calibration.stereo;
    model.rig = rig;
    model.covariance = calibration.covariance.value_or(RigCovariance::Zero());
    model.target = *points;
    model.limits = limits_of(config);
    model.volume = WorkingVolume{config.volume.min_mm, config.volume.max_mm};
    model.method = config.output.method == ConfiguredMethod::kPaper ? Method::kPaper : Method::kMaximumLikelihood;
    if (config.output.frame == ConfiguredFrame::kLeftCamera) model.output_from_rig = rig.camera_from_rig.left;
    return model;
  });
}

Result<UnitSetup> unit_setup(const Config& config) {
  if (const Result<void> detector = check_detector(config); !detector) return tl::make_unexpected(detector.error());
  const Result<TargetFile> target =
      config.target_file.empty() ? Result<TargetFile>(single_led()) : load_target(config.target_file);
  if (!target) return tl::make_unexpected(named_by(config, "target.file", target.error()));

  UnitSetup setup;
  const Result<Target> points = points_of(*target);
  if (!points && config.modulation.enabled) return tl::make_unexpected(named_by(config, "target.file", points.error()));
  setup.target = points.value_or(Target{});
  if (!config.calibration_file.empty()) {
    Result<Calibration> calibration = load_calibration(config.calibration_file);
    const Result<void> usable =
        calibration.and_then([&](const Calibration& loaded) { return check_size(config, loaded); });
    if (!usable) return tl::make_unexpected(named_by(config, "calibration.file", usable.error()));
    Result<LineModel> model = line_model(*calibration, *target, config);
    if (!model) return tl::make_unexpected(named_by(config, "target.file", model.error()));
    setup.model = std::make_shared<const LineModel>(std::move(*model));
    setup.calibration = std::move(*calibration);
  }
  setup.constants = constants_of(config, setup.calibration, *target);
  return setup;
}

std::string setup_text(std::uint16_t setup) { return fmt::format("{} (0x{:04X})", setup, setup); }

CalibrationFits fits_calibration(const std::optional<Calibration>& calibration, CameraSource source) {
  return [calibration, source, fits = PerSide<bool>{true, true}](const PerSide<CameraStatus>& cameras) mutable {
    if (!calibration) return true;
    for (const Side side : kBothSides) {
      const CameraInfo& camera = cameras[side].info;
      if (!cameras[side].delivering) continue;
      const bool same = source == CameraSource::kRecording ||
                        (camera.serial == calibration->serial[side] &&
                         (has_unique_serials(*calibration) || camera.port == calibration->port[side]));
      fits[side] = same && camera.size == calibration->stereo.cameras[side].size;
    }
    return fits.left && fits.right;
  };
}

}  // namespace tripoint
