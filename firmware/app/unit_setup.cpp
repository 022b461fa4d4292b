#include "app/unit_setup.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "app/camera_supply.h"
#include "app/datum_check.h"
#include "app/detection.h"
#include "app/version.h"
#include "config/target_shape.h"
#include "document/sha256.h"
#include "line/pose/output_frame.h"

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

Target target_of_leds(const TargetFile& file) {
  Target target;
  for (const TargetFilePoint& point : file.points) {
    target.points.push_back({point.id, point.position_mm, point.uncertainty_mm, point.facing});
  }
  if (file.facing) target.facing = *file.facing;
  return target;
}

Target target_of_tags(const TargetFile& file) {
  Target target;
  for (const TargetFileTag& tag : file.tags) {
    const double angle_rad = tag.rotation_rad.norm();
    const Vec3 axis = angle_rad > 0.0 ? Vec3(tag.rotation_rad / angle_rad) : Vec3(Vec3::UnitZ());
    const Matrix3 target_from_tag = Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
    TargetTag placed;
    placed.id = tag.id;
    placed.uncertainty_mm = tag.uncertainty_mm;
    for (std::size_t k = 0; k < kTagCorners; ++k) {
      const Vec3 in_tag_mm = 0.5 * tag.size_mm * Vec3(kTagCornerPlaces[k][0], kTagCornerPlaces[k][1], 0.0);
      placed.corners_mm[k] = tag.position_mm + target_from_tag * in_tag_mm;
    }
    target.points.push_back({tag.id, tag.position_mm, tag.uncertainty_mm, std::nullopt});
    target.tags.push_back(placed);
  }
  return target;
}

registers::Mode mode_of(const Target& target) {
  if (!target.tags.empty()) return registers::Mode::kApriltagPose;
  return target.points.size() < 3 ? registers::Mode::kLedPosition : registers::Mode::kLedPose;
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

/// Tags by their bits, three LEDs and more by their distances.
bool shows_an_identity(const TargetFile& target) {
  return target.kind == TargetKind::kAprilTag || target.points.size() >= 3;
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
  if (!config.modulation.enabled && !shows_an_identity(target)) constants.warnings.insert(Warning::kLightUnproved);
  if (calibration) {
    constants.verified = verified_by_length(*calibration);
    if (!has_unique_serials(*calibration)) constants.warnings.insert(Warning::kNoUniqueSerial);
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

/// The paper's method needs three centres that say how the target is turned.
Result<void> check_centres(const TargetFile& file) {
  std::vector<Vec3> centres_mm;
  for (const TargetFileTag& tag : file.tags) centres_mm.push_back(tag.position_mm);
  if (!nearly_on_a_line(centres_mm)) return {};
  return failure(
      ErrorCode::kMismatch,
      fmt::format("output.method is \"paper\", but the centres of the tags {}: set it to "
                  "\"maximum_likelihood\", or place three tags in a triangle that is at least {:.0f} % as wide "
                  "as long",
                  centres_mm.size() < 3 ? "are fewer than three" : "lie nearly on a line", 100.0 * kLeastWidthShare));
}

}  // namespace

Result<void> check_detector(const Config& config) {
  if (config.detector.kind != ConfiguredDetector::kSphere) return {};
  return tl::make_unexpected(named_by(config, "detector.kind",
                                      {ErrorCode::kMismatch,
                                       "\"sphere\" is for single pictures, with `tripointd detect`: to measure set "
                                       "\"led\" or \"apriltag\""}));
}

Result<MeasuredTarget> measured_target(const TargetFile& file, const Config& config) {
  const bool tags = file.kind == TargetKind::kAprilTag;
  if (tags != (config.detector.kind == ConfiguredDetector::kAprilTag)) {
    return failure(
        ErrorCode::kMismatch,
        tags ? "the target is made of AprilTags, but detector.kind is \"led\": set it to \"apriltag\", or name "
               "a target of LEDs"
             : "the target is made of LEDs, but detector.kind is \"apriltag\": set it to \"led\", or name a "
               "target of tags");
  }
  if (tags && config.output.method == ConfiguredMethod::kPaper) {
    if (const Result<void> usable = check_centres(file); !usable) return tl::make_unexpected(usable.error());
  }
  MeasuredTarget target{tags ? target_of_tags(file) : target_of_leds(file), file.family};
  return detection_of(config.detector, target).map([&](const DetectPoints& /*works*/) { return target; });
}

Result<LineModel> line_model(const Calibration& calibration, const Target& target, const Config& config) {
  return rig_of(calibration.stereo).map([&](const Rig& rig) {
    LineModel model;
    model.calibration = calibration.stereo;
    model.rig = rig;
    model.covariance = calibration.covariance.value_or(RigCovariance::Zero());
    model.target = target;
    model.limits = limits_of(config);
    give_poses_in(output_frame(config.output.frame), model);
    model.volume = WorkingVolume{config.volume.min_mm, config.volume.max_mm, model.output_from_rig};
    if (const std::optional<DatumConfig>& datum = config.datum) {
      model.datum = Datum{datum->position_mm, datum->uncertainty_mm, datum->radius_mm};
    }
    model.method = config.output.method == ConfiguredMethod::kPaper ? Method::kPaper : Method::kMaximumLikelihood;
    return model;
  });
}

Result<UnitSetup> unit_setup(const Config& config) {
  if (const Result<void> detector = check_detector(config); !detector) return tl::make_unexpected(detector.error());
  const Result<TargetFile> file =
      config.target_file.empty() ? Result<TargetFile>(single_led()) : load_target(config.target_file);
  const Result<MeasuredTarget> target =
      file.and_then([&](const TargetFile& loaded) { return measured_target(loaded, config); });
  if (!target) return tl::make_unexpected(named_by(config, "target.file", target.error()));

  UnitSetup setup;
  setup.target = *target;
  if (!config.calibration_file.empty()) {
    Result<Calibration> calibration = load_calibration(config.calibration_file);
    const Result<void> usable =
        calibration.and_then([&](const Calibration& loaded) { return check_size(config, loaded); });
    if (!usable) return tl::make_unexpected(named_by(config, "calibration.file", usable.error()));
    Result<LineModel> model = line_model(*calibration, setup.target.target, config);
    if (!model) return tl::make_unexpected(named_by(config, "calibration.file", model.error()));
    setup.model = std::make_shared<const LineModel>(std::move(*model));
    setup.calibration = std::move(*calibration);
  }
  if (const Result<void> datum = check_datum(config, setup.model.get()); !datum) {
    return tl::make_unexpected(datum.error());
  }
  setup.constants = constants_of(config, setup.calibration, *file);
  setup.constants.identity.mode = mode_of(setup.target.target);
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
